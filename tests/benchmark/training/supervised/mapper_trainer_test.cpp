// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "agent/models/safetensors.h"
#include "agent/perception/learned_mapper.h"
#include "benchmark/training/supervised/mapper_training.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/benchmark/training/supervised/bar_world.h"
#include "tests/benchmark/training/supervised/integers_beside_weights.h"
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
  tests::ExpectIntegersBesideWeights(folder_.path());
}

TEST_F(MapperTrainerTest, StartsFromWeightsOfItsShape) {
  MapperTrainConfig config = TinyConfig(folder_.path() / "first");
  Watcher watcher;
  Train(config, &watcher);
  config.start = (folder_.path() / "first/weights.safetensors").string();
  config.out = (folder_.path() / "second").string();
  config.optimiser.learning_rate = 1e-12;  // too little to change a stored number
  Train(config, &watcher);
  const auto first = agent::ReadTensorFile(*config.start).tensors;
  const auto second = agent::ReadTensorFile(folder_.path() / "second/weights.safetensors").tensors;
  EXPECT_EQ(first.at("rays.weight"), second.at("rays.weight"));

  config.model.features = 8;
  EXPECT_THROW(Train(config, &watcher), sim::FileError);
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
