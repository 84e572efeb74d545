// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_config.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

PerceptionConfig Parse(const std::string& text) {
  return sim::LoadYamlText<PerceptionConfig>(text, "test.yaml");
}

std::string ErrorOf(const std::string& text) {
  try {
    Parse(text);
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "";
}

TEST(PerceptionConfig, AsksForSixtyPointsUnlessTold) {
  EXPECT_EQ(Parse("data: {scenes: [a.glb]}").data.points, 60);
  EXPECT_EQ(Parse("data: {scenes: [a.glb], points: 9}").data.points, 9);
}

TEST(PerceptionConfig, ShippedOneIsOfTheTestHouses) {
  const auto config =
      sim::LoadYaml<PerceptionConfig>(std::filesystem::path(BULLETNAV_CONFIGS) / "perception.yaml");
  EXPECT_EQ(config.data.houses->split, "test");
}

TEST(PerceptionConfig, ShippedOneOfRealScenesTakesAFolder) {
  const auto config = sim::LoadYaml<PerceptionConfig>(std::filesystem::path(BULLETNAV_CONFIGS) /
                                                      "perception_real.yaml");
  EXPECT_EQ(config.data.scenes, std::vector<std::string>{"data/real_scenes"});
  EXPECT_TRUE(config.data.import.ground_plane);
}

TEST(PerceptionConfig, ShippedOneToQuantiseByHasHousesOfItsOwn) {
  const auto config =
      sim::LoadYaml<PerceptionConfig>(std::filesystem::path(BULLETNAV_CONFIGS) / "quantise.yaml");
  EXPECT_FALSE(config.data.houses.has_value());
  EXPECT_EQ(config.data.more_houses->first_seed, 20000u);
}

TEST(PerceptionConfig, BadOnesAreOneClearLine) {
  EXPECT_THAT(ErrorOf("seed: 1"), HasSubstr("key 'data' is missing"));
  EXPECT_THAT(ErrorOf("data: {scenes: [a.glb], points: 1}"), HasSubstr("at least 2"));
  EXPECT_THAT(ErrorOf("data: {scenes: [a.glb]}\nsame_node: 1.5"), HasSubstr("between 0 and 1"));
  EXPECT_THAT(ErrorOf("data: {scenes: [a.glb]}\npicture: 1"), HasSubstr("pictures"));
}

}  // namespace
}  // namespace bulletnav::bench
