// SPDX-License-Identifier: MIT
#include "benchmark/episodes/generator.h"

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "benchmark/episodes/episode_file.h"
#include "benchmark/episodes/scene_cache.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class GeneratorTest : public testing::Test {
 protected:
  GeneratorTest() {
    spec_.out = "x.json";
    spec_.counts = {7, 5, 4, 3};
    spec_.sequential_goals = 3;
    for (const float length : {9.0f, 10.0f, 11.0f}) {
      const auto file =
          folder_.path() / ("corridor" + std::to_string(spec_.scenes.size()) + ".glb");
      const auto mesh = tests::LCorridor(length, 8, 2, 2.5f);
      sim::WriteFileAtomically(file, sim::EncodeGlb(mesh));
      spec_.scenes.push_back(file.string());
    }
  }
  std::string ConfigComplaint(const std::string& text) const {
    try {
      sim::LoadYamlText<GeneratorSpec>(text, "c.yaml");
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "nothing";
  }

  tests::TemporaryFolder folder_;
  GeneratorSpec spec_;
};

TEST_F(GeneratorTest, SpreadsEpisodesEvenlyInEveryFirstPart) {
  const auto episodes = GenerateEpisodes(spec_, spec_.scenes, 1);
  ASSERT_EQ(episodes.size(), 19u);
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const Episode& episode : episodes) {
    ++counts[{episode.difficulty ? std::string(DifficultyName(*episode.difficulty)) : "sequence",
              episode.scene}];
  }
  EXPECT_EQ(counts.size(), 12u);
  const auto count = [&](const char* kind, std::size_t scene) {
    return counts[{kind, spec_.scenes[scene]}];
  };
  EXPECT_EQ(count("easy", 0), 3);
  EXPECT_EQ(count("easy", 1), 2);
  EXPECT_EQ(count("medium", 1), 2);
  EXPECT_EQ(count("medium", 2), 1);
  EXPECT_EQ(count("sequence", 2), 1);
  // The first twelve are one of each kind from each scene.
  std::map<std::string, int> first;
  for (std::size_t i = 0; i < 12; ++i) ++first[episodes[i].scene];
  EXPECT_THAT(first, testing::Each(testing::Pair(testing::_, 4)));
  EXPECT_NO_THROW(RequireUniqueIds(episodes, "x"));
}

TEST_F(GeneratorTest, KindsShareOutManyScenes) {
  spec_.counts = {.easy = 1, .medium = 1, .hard = 1};
  std::vector<std::string> told;
  const auto warn = [&](const std::string& text) {
    told.push_back(text);
  };
  std::set<std::string> played;
  for (const Episode& one : GenerateEpisodes(spec_, spec_.scenes, 1)) played.insert(one.scene);
  EXPECT_EQ(played.size(), 3u);
  WarnOfScenesLeftOut(spec_, spec_.scenes, warn);
  EXPECT_THAT(told, testing::IsEmpty());
  spec_.counts.hard = 0;
  WarnOfScenesLeftOut(spec_, spec_.scenes, warn);
  EXPECT_THAT(told, testing::ElementsAre(HasSubstr("3 scenes share 2 episodes")));
}

TEST_F(GeneratorTest, IsTheSameForAnyNumberOfWorkers) {
  const auto one = GenerateEpisodes(spec_, spec_.scenes, 1);
  int done = 0;
  std::mutex mutex;
  EXPECT_EQ(GenerateEpisodes(spec_, spec_.scenes, 2,
                             [&] {
                               const std::lock_guard lock(mutex);
                               ++done;
                             }),
            one);
  EXPECT_EQ(done, 3);
  EXPECT_EQ(GenerateEpisodes(spec_, spec_.scenes, 7), one);
  spec_.seed = 1;
  EXPECT_NE(GenerateEpisodes(spec_, spec_.scenes, 1), one);
}

TEST_F(GeneratorTest, ScenesOfOneNameInTwoFoldersAreToldApart) {
  std::vector<std::string> scenes;
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directories(folder_.path() / name);
    scenes.push_back((folder_.path() / name / "scene.glb").string());
    std::filesystem::copy_file(spec_.scenes[0], scenes.back());
  }
  const auto episodes = GenerateEpisodes(spec_, scenes, 1);
  EXPECT_EQ(episodes[0].id, "a-scene-easy-0000");
  EXPECT_EQ(episodes[1].id, "b-scene-easy-0000");
}

TEST_F(GeneratorTest, RefusesASceneThatIsNamedTwice) {
  spec_.scenes.push_back(spec_.scenes[0]);
  EXPECT_THROW(GenerateEpisodes(spec_, spec_.scenes, 1), sim::FileError);
}

TEST_F(GeneratorTest, NamesASceneThatIsMissing) {
  spec_.scenes.emplace_back("no_such.glb");
  EXPECT_THROW(GenerateEpisodes(spec_, spec_.scenes, 1), sim::FileError);
}

TEST_F(GeneratorTest, DrawsFreeEpisodesInHousesOfTheIndex) {
  tests::WriteShellHouses(folder_.path(), 3, 2);
  spec_.scenes.clear();
  spec_.houses = HouseSelection{(folder_.path() / "index.json").string(), "test"};
  const auto scenes = ScenesOf(spec_);
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_THAT(scenes[0], HasSubstr("house_001.glb"));
  const auto episodes = GenerateEpisodes(spec_, scenes, 2);
  EXPECT_EQ(episodes.size(), 19u);
  for (const std::string& scene : scenes) {
    const auto ground = SceneCache({}).LoadGround(scene);
    for (const Episode& episode : episodes) {
      if (episode.scene != scene) continue;
      EXPECT_NO_THROW(CheckEpisode(episode, ground->physics, ground->navmesh, {}));
    }
  }
  spec_.houses->split = "val";
  EXPECT_THROW(ScenesOf(spec_), sim::FileError);
  spec_.houses->index = "nowhere/index.json";
  EXPECT_THROW(ScenesOf(spec_), sim::FileError);
}

TEST_F(GeneratorTest, DrawsFreeEpisodesInARealScene) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scenes";
  const auto ground = SceneCache({}).LoadGround(*file);
  for (const Episode& episode : GenerateEpisodes(spec_, {file->string()}, 1)) {
    EXPECT_NO_THROW(CheckEpisode(episode, ground->physics, ground->navmesh, {}));
  }
}

TEST_F(GeneratorTest, ConfigSaysWhatIsWrongWhere) {
  const std::string sound = "scenes: [a.glb]\ncounts: {easy: 10}\nout: x.json.gz\n";
  const auto spec = sim::LoadYamlText<GeneratorSpec>(sound, "c.yaml");
  EXPECT_EQ(spec.counts.easy, 10);
  EXPECT_EQ(spec.scenes, std::vector<std::string>{"a.glb"});
  EXPECT_THAT(ConfigComplaint(sound + "sed: 3\n"),
              AllOf(HasSubstr("c.yaml:4:1"), HasSubstr("seed")));
  EXPECT_THAT(ConfigComplaint("counts: {easy: 1}\nout: x\n"), HasSubstr("names no scenes"));
  EXPECT_THAT(ConfigComplaint("scenes: [a]\nout: x\n"), HasSubstr("asks for no episodes"));
  EXPECT_THAT(ConfigComplaint("scenes: [a]\ncounts: {easy: -1}\nout: x\n"),
              AllOf(HasSubstr("c.yaml:2:"), HasSubstr("between 0 and")));
  EXPECT_THAT(ConfigComplaint("scenes: [a]\ncounts: {easy: 1}\n"), HasSubstr("'out' is missing"));
  EXPECT_THAT(ConfigComplaint(sound + "import: {scale: 0}\n"), HasSubstr("c.yaml:4:"));
  EXPECT_THAT(ConfigComplaint(sound + "houses: {split: val}\n"), HasSubstr("'index' is missing"));
}

TEST_F(GeneratorTest, ShippedConfigsLoad) {
  const std::filesystem::path configs = BULLETNAV_CONFIGS;
  const auto spec = sim::LoadYaml<GeneratorSpec>(configs / "episodes.yaml");
  EXPECT_EQ(spec.counts.easy, 1000);
  EXPECT_EQ(spec.counts.hard, 1000);
  const auto sequential = sim::LoadYaml<GeneratorSpec>(configs / "episodes_sequential.yaml");
  EXPECT_EQ(sequential.counts.sequential, 1000);
}

TEST(ScenesOf, TakesAllMeshesBelowAFolder) {
  const tests::TemporaryFolder folder;
  for (const char* file : {"shop/scene.obj", "shop/scene.mtl", "a.glb", "house/deep/B.PLY"}) {
    std::filesystem::create_directories((folder.path() / file).parent_path());
    sim::WriteFileAtomically(folder.path() / file, "x");
  }
  GeneratorSpec spec;
  spec.scenes = {"first.glb", folder.path().string()};
  const auto at = [&](const char* file) {
    return (folder.path() / file).string();
  };
  EXPECT_EQ(ScenesOf(spec),
            (std::vector<std::string>{"first.glb", at("a.glb"), at("house/deep/B.PLY"),
                                      at("shop/scene.obj")}));
  std::filesystem::create_directories(folder.path() / "empty");
  const auto error_of = [&](const char* scenes) -> std::string {
    spec.scenes = {at(scenes)};
    try {
      ScenesOf(spec);
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("empty"), HasSubstr("empty: holds no mesh; put meshes (.glb, "));
  EXPECT_THAT(error_of("nowhere"),
              AllOf(HasSubstr("nowhere: there is no such folder; put meshes (.glb, "),
                    HasSubstr("the key 'scenes' (of a run: episodes.draw.scenes=[FOLDER])")));
}

TEST(ScenesOf, LinksBackAreNotFollowed) {
  const tests::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "shops/first");
  std::filesystem::create_directories(folder.path() / "elsewhere");
  sim::WriteFileAtomically(folder.path() / "shops/first/scene.obj", "x");
  sim::WriteFileAtomically(folder.path() / "elsewhere/b.glb", "x");
  std::filesystem::create_directory_symlink("../..", folder.path() / "shops/first/up");
  std::filesystem::create_directory_symlink(".", folder.path() / "shops/same");
  std::filesystem::create_directory_symlink("../elsewhere", folder.path() / "shops/link");
  GeneratorSpec spec;
  spec.scenes = {(folder.path() / "shops").string()};
  EXPECT_EQ(ScenesOf(spec),
            (std::vector<std::string>{(folder.path() / "shops/first/scene.obj").string(),
                                      (folder.path() / "shops/link/b.glb").string()}));
}

TEST(ScenesOf, AFolderOfScansHasEachOnce) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"a.glb", "a.basis.glb", "a.semantic.glb", "b.basis.glb", "c.ply",
                           "c_semantic.ply", "c.navmesh"}) {
    folder.Write(name, "");
  }
  GeneratorSpec spec;
  spec.scenes = {folder.path().string()};
  std::vector<std::string> names;
  for (const std::filesystem::path scene : ScenesOf(spec)) names.push_back(scene.filename());
  EXPECT_EQ(names, (std::vector<std::string>{"a.glb", "b.basis.glb", "c.ply"}));
}

TEST(ScenesOf, MeshesThatScenesAreMadeOfAreNoScenes) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"set/x.scene_dataset_config.json", "set/stages/room.glb",
                           "set/objects/chair.glb", "set/scenes/one.scene_instance.json",
                           "set_of_scans/y.scene_dataset_config.json", "set_of_scans/house.glb"}) {
    folder.Write(name, "");
  }
  GeneratorSpec spec;
  spec.scenes = {folder.path().string()};
  std::vector<std::string> names;
  for (const std::filesystem::path scene : ScenesOf(spec)) names.push_back(scene.filename());
  EXPECT_EQ(names, (std::vector<std::string>{"one.scene_instance.json", "house.glb"}));
}

}  // namespace
}  // namespace bulletnav::bench
