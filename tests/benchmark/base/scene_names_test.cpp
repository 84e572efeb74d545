// SPDX-License-Identifier: MIT
#include "benchmark/base/scene_names.h"

#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;

std::vector<std::string> NamesOf(const std::vector<std::string>& scenes) {
  const std::map<std::string, std::string> called = SceneNames(scenes);
  std::vector<std::string> names;
  for (const std::string& scene : scenes) names.push_back(called.at(scene));
  return names;
}

TEST(SceneNames, AreAsShortAsTellsThemApart) {
  EXPECT_THAT(NamesOf({"a/house_0.glb", "b/house_1.glb"}), ElementsAre("house_0", "house_1"));
  EXPECT_THAT(NamesOf({"x/aws_house/scene.obj", "x/aws_bookstore/scene.obj", "x/office.glb"}),
              ElementsAre("aws_house/scene", "aws_bookstore/scene", "office"));
  EXPECT_THAT(NamesOf({"replica/room_0/habitat/mesh.ply", "replica/room_1/habitat/mesh.ply"}),
              ElementsAre("room_0/habitat/mesh", "room_1/habitat/mesh"));
  EXPECT_THAT(NamesOf({"scene.obj", "a/scene.obj"}), ElementsAre("scene", "a/scene"));
  EXPECT_THAT(NamesOf({"a/scene.obj", "a/scene.glb"}), ElementsAre("a/scene.obj", "a/scene.glb"));
  EXPECT_THAT(NamesOf({"scenes/apt_0.scene_instance.json"}), ElementsAre("apt_0"));
  EXPECT_THAT(NamesOf({"a/b.glb", "a/b.glb"}), ElementsAre("b", "b"));
}

TEST(SceneNames, NoTwoScenesShareOne) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    sim::Rng rng(seed, "scene names");
    std::set<std::string> scenes;
    for (int i = 0; i < 8; ++i) {
      std::string scene;
      for (int depth = rng.Below(4); depth > 0; --depth) scene += rng.Chance(0.5) ? "a/" : "b/";
      scenes.insert(scene + (rng.Chance(0.7) ? "scene" : "b") +
                    (rng.Chance(0.8) ? ".obj" : ".glb"));
    }
    const std::vector<std::string> list(scenes.begin(), scenes.end());
    const std::vector<std::string> names = NamesOf(list);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), list.size()) << seed;
  }
}

TEST(SceneNames, EpisodesAreCalledWithTheirScene) {
  EXPECT_EQ(EpisodeName("a/house_0.glb", "house_0-easy-3"), "house_0-easy-3");
  EXPECT_EQ(EpisodeName("a/Denmark.glb", "7"), "a/Denmark, episode 7");
}

}  // namespace
}  // namespace bulletnav::bench
