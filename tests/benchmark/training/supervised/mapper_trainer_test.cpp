// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <limits>

#include <gmock/gmock.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/safetensors.h"
#include "agent/perception/learned_mapper.h"
#include "benchmark/training/supervised/mapper_training.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/benchmark/training/supervised/bar_world.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using tests::BarSource;
using tests::Killed;
using tests::Watcher;

MapperTrainConfig TinyConfig(const fs::path& out) {
  auto config = tests::TinyTraining<MapperTrainConfig>(out);
  config.model.features = 16;
  return config;
}

class MapperTrainerTest : public testing::Test {
 protected:
  void Train(const MapperTrainConfig& config, TrainObserver* observer) {
    RunTraining(tests::JobOn<MapperTraining, BarSource>(config), observer);
  }
  tests::TemporaryFolder folder_;
};

TEST_F(MapperTrainerTest, ResumedIsTheSameAsUninterruptedBitForBit) {
  MapperTrainConfig config = TinyConfig(folder_.path() / "whole");
  Watcher whole;
  Train(config, &whole);
  EXPECT_THAT(whole.text(), HasSubstr("explored IoU"));
  const std::string curves = sim::ReadTextFile(folder_.path() / "whole/curves.csv");
  EXPECT_THAT(curves, StartsWith("step,rate,train_loss,loss,explored_iou,"));
  const auto weights = agent::ReadTensorFile(folder_.path() / "whole/weights.safetensors").tensors;

  config.out = folder_.path() / "parts";
  Watcher killed(5);
  EXPECT_THROW(Train(config, &killed), Killed);
  Watcher rest;
  Train(config, &rest);
  EXPECT_EQ(rest.resumed(), 4);
  EXPECT_EQ(sim::ReadTextFile(folder_.path() / "parts/curves.csv"), curves);
  EXPECT_EQ(agent::ReadTensorFile(folder_.path() / "parts/weights.safetensors").tensors, weights);
  EXPECT_TRUE(fs::exists(folder_.path() / "parts/curves.png"));
}

TEST_F(MapperTrainerTest, QuantisesAtItsEndAndTellsBothAccuracies) {
  MapperTrainConfig config = TinyConfig(folder_.path());
  config.model.width = 16;
  Watcher watcher;
  Train(config, &watcher);
  const fs::path weights = folder_.path() / "weights.safetensors";
  EXPECT_TRUE(agent::HoldsIntegers(agent::ReadTensorFile(weights)));
  EXPECT_FALSE(
      agent::HoldsIntegers(agent::ReadTensorFile(folder_.path() / "weights_best.safetensors")));
  // As trained, in integers: not the same, but near.
  const std::string card = sim::ReadTextFile(folder_.path() / "weights.md");
  EXPECT_THAT(card, HasSubstr("| measure | as trained | in integers |"));
  double floats = 0.0;
  double integers = 0.0;
  const std::size_t row = card.find("| loss | ");
  ASSERT_NE(row, std::string::npos) << card;
  ASSERT_EQ(std::sscanf(card.c_str() + row, "| loss | %lf | %lf |", &floats, &integers), 2);
  EXPECT_NEAR(floats, integers, 0.05 * floats) << card;
}

TEST_F(MapperTrainerTest, AgentsCanUseWhatItWrites) {
  const MapperTrainConfig config = TinyConfig(folder_.path());
  Watcher watcher;
  Train(config, &watcher);
  agent::Rig rig;
  rig.has_depth = false;
  agent::LearnedMapper mapper(folder_.path() / "weights_best.safetensors", rig);
  const PairBatch batch = BarSource(2, 3).Batch(0);
  const agent::FreeSpace space =
      mapper.Predict({std::span(batch.color).first(batch.color.size() / 2), {}});
  EXPECT_TRUE(std::isfinite(space.explored[0]));
}

TEST_F(MapperTrainerTest, StopsAtALossThatIsNoNumber) {
  MapperTrainConfig config = TinyConfig(folder_.path());
  config.obstacle_weight = std::numeric_limits<double>::quiet_NaN();
  Watcher watcher;
  try {
    Train(config, &watcher);
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("nan at step 1"));
  }
}

TEST(MapperTrainConfig, RefusesWhatMakesNoSense) {
  MapperTrainConfig config = TinyConfig("out");
  EXPECT_NO_THROW(config.Validate());
  config.obstacle_weight = 0.0;
  EXPECT_THROW(config.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
