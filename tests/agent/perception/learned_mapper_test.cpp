// SPDX-License-Identifier: MIT
#include "agent/perception/learned_mapper.h"

#include <algorithm>
#include <thread>

#include <gtest/gtest.h>

#include "agent/perception/mapper_net.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

std::vector<std::uint8_t> Noise(std::uint64_t seed) {
  sim::Rng rng(seed, "picture");
  std::vector<std::uint8_t> color(128 * 512 * 3);
  for (auto& value : color) value = static_cast<std::uint8_t>(rng.Next() & 255u);
  return color;
}

Rig ColorRig() {
  Rig rig;
  rig.has_depth = false;
  return rig;
}

class LearnedMapperTest : public testing::TestWithParam<Precision> {
 protected:
  std::filesystem::path Save(Precision precision) const {
    MapperConfig config;
    config.width = 16;
    config.features = 32;
    config.precision = precision;
    const auto file = folder_.path() / "tiny.safetensors";
    SaveMapper(MapperNet(config, 3), {}, StoredType::kFloat32, file);
    return file;
  }
  tests::TemporaryFolder folder_;
};

TEST_P(LearnedMapperTest, AnswersAreTheSameInEveryThreadAndOrder) {
  const auto file = Save(GetParam());
  const auto first = Noise(1);
  const auto second = Noise(2);
  LearnedMapper mapper(file, ColorRig());
  const FreeSpace expected = mapper.Predict({first, {}});
  std::vector<std::vector<float>> answers(3);
  std::vector<std::thread> threads;
  for (auto& answer : answers) {
    threads.emplace_back([&] {
      LearnedMapper other(file, ColorRig());
      other.Predict({second, {}});
      answer = other.Predict({first, {}}).obstacle.values();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& answer : answers) EXPECT_EQ(answer, expected.obstacle.values());
  EXPECT_NE(mapper.Predict({second, {}}).explored.values(), expected.explored.values());
}

INSTANTIATE_TEST_SUITE_P(All, LearnedMapperTest,
                         testing::Values(Precision::kFloat32, Precision::kBfloat16),
                         [](const auto& precision) {
                           return std::string(sim::NameOf(precision.param));
                         });

TEST_F(LearnedMapperTest, AnswersAreProbabilities) {
  const auto color = Noise(1);
  const FreeSpace space =
      LearnedMapper(Save(Precision::kBfloat16), ColorRig()).Predict({color, {}});
  for (const auto* map : {&space.explored, &space.obstacle}) {
    for (const float p : map->values()) ASSERT_TRUE(p > 0.0f && p < 1.0f);
  }
}

TEST_F(LearnedMapperTest, NearlyTheSameAsFloat32InBfloat16) {
  const auto color = Noise(1);
  const FreeSpace coarse =
      LearnedMapper(Save(Precision::kBfloat16), ColorRig()).Predict({color, {}});
  const FreeSpace fine = LearnedMapper(Save(Precision::kFloat32), ColorRig()).Predict({color, {}});
  double worst = 0.0;
  for (std::size_t i = 0; i < fine.explored.values().size(); ++i) {
    worst = std::max(worst, std::abs(double{fine.explored[i]} - double{coarse.explored[i]}));
  }
  EXPECT_LT(worst, 0.02);
}

TEST_F(LearnedMapperTest, RefusesRigsThatDoNotGiveWhatItTakes) {
  const auto file = Save(Precision::kBfloat16);
  Rig rig;
  EXPECT_NO_THROW(LearnedMapper(file, rig));
  rig.has_color = false;
  EXPECT_THROW(LearnedMapper(file, rig), sim::Error);
  rig = {};
  rig.panorama.rows = 64;
  EXPECT_THROW(LearnedMapper(file, rig), sim::Error);
  EXPECT_THROW(LearnedMapper(folder_.path() / "none", Rig{}), sim::FileError);
}

}  // namespace
}  // namespace bulletnav::agent
