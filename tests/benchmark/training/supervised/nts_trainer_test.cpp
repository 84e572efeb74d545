// SPDX-License-Identifier: MIT
#include <limits>
#include <sstream>

#include <gmock/gmock.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/perception/semantic_net.h"
#include "agent/perception/weights.h"
#include "benchmark/training/core/training_log.h"
#include "benchmark/training/supervised/nts_training.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/benchmark/training/supervised/bar_world.h"
#include "tests/benchmark/training/supervised/integers_beside_weights.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using tests::BarSource;
using tests::Killed;
using tests::Watcher;

TrainConfig TinyConfig(const fs::path& out) {
  auto config = tests::TinyTraining<TrainConfig>(out);
  config.model.pair_features = 32;
  config.pairs = 8;
  return config;
}

class TrainNtsTest : public testing::Test {
 protected:
  void Train(const TrainConfig& config, TrainObserver* observer) {
    RunTraining(tests::JobOn<NtsTraining, BarSource>(config), observer);
  }
  std::string Complaint(const TrainConfig& config) {
    Watcher watcher;
    try {
      Train(config, &watcher);
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "none";
  }
  tests::TemporaryFolder folder_;
};

TEST_F(TrainNtsTest, ResumedIsTheSameAsUninterruptedBitForBit) {
  TrainConfig config = TinyConfig(folder_.path() / "whole");
  Watcher whole;
  Train(config, &whole);
  const std::string curves = sim::ReadTextFile(folder_.path() / "whole/curves.csv");
  const auto weights = agent::ReadTensorFile(folder_.path() / "whole/weights.safetensors").tensors;

  config.out = folder_.path() / "parts";
  Watcher killed(5);
  EXPECT_THROW(Train(config, &killed), Killed);
  Watcher rest;
  Train(config, &rest);
  EXPECT_EQ(rest.resumed(), 4);
  EXPECT_EQ(sim::ReadTextFile(folder_.path() / "parts/curves.csv"), curves);
  EXPECT_EQ(agent::ReadTensorFile(folder_.path() / "parts/weights.safetensors").tensors, weights);
  EXPECT_EQ(agent::FramesTrained(folder_.path() / "parts/weights.safetensors"), 48);
  EXPECT_TRUE(fs::exists(folder_.path() / "parts/weights_best.safetensors"));
  EXPECT_TRUE(fs::exists(folder_.path() / "parts/curves.png"));
  EXPECT_THAT(sim::ReadTextFile(folder_.path() / "parts/weights.md"),
              AllOf(HasSubstr("| 6 of 6, 48 panoramas in all |"), HasSubstr("| connection | "),
                    HasSubstr("pair_features: 32")));
}

TEST_F(TrainNtsTest, DamagedCheckpointFallsBackToTheOneBefore) {
  const TrainConfig config = TinyConfig(folder_.path());
  Watcher killed(5);
  EXPECT_THROW(Train(config, &killed), Killed);
  std::string bytes = sim::ReadTextFile(folder_.path() / "checkpoint.safetensors");
  bytes.resize(bytes.size() / 2);
  sim::WriteFileAtomically(folder_.path() / "checkpoint.safetensors", bytes);
  Watcher rest;
  testing::internal::CaptureStderr();
  Train(config, &rest);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("warning"), HasSubstr("/checkpoint.safetensors"),
                    HasSubstr("going on from")));
  EXPECT_EQ(rest.resumed(), 2);
  fs::remove(folder_.path() / "checkpoint_previous.safetensors");
  sim::WriteFileAtomically(folder_.path() / "checkpoint.safetensors", bytes);
  EXPECT_THAT(Complaint(config), HasSubstr("damaged"));
}

TEST_F(TrainNtsTest, QuantisesAtItsEndAndTellsBothAccuracies) {
  TrainConfig config = TinyConfig(folder_.path());
  config.model.width = 16;
  Watcher watcher;
  Train(config, &watcher);
  tests::ExpectIntegersBesideWeights(folder_.path());
}

TEST_F(TrainNtsTest, StartsFromWeights) {
  TrainConfig config = TinyConfig(folder_.path() / "first");
  Watcher watcher;
  Train(config, &watcher);
  config.start = (folder_.path() / "first/weights.safetensors").string();
  config.out = (folder_.path() / "second").string();
  config.optimiser.learning_rate = 1e-12;  // all but none
  Train(config, &watcher);

  const auto first = agent::ReadTensorFile(*config.start).tensors;
  const auto second = agent::ReadTensorFile(folder_.path() / "second/weights.safetensors").tensors;
  agent::SemanticNet net(config.model, 0);
  const auto parameters = net.named_parameters();
  for (const auto& item : parameters) {
    EXPECT_TRUE(at::allclose(agent::FromStored(first.at(item.key())),
                             agent::FromStored(second.at(item.key())), 0.0, 1e-9))
        << item.key();
  }
  EXPECT_EQ(agent::FramesTrained(folder_.path() / "second/weights.safetensors"), 96);
  EXPECT_THAT(sim::ReadTextFile(folder_.path() / "second/weights.md"),
              HasSubstr("48 panoramas in all, on"));
}

TEST_F(TrainNtsTest, SaysWhatIsWrongWithWeightsToStartFrom) {
  TrainConfig config = TinyConfig(folder_.path() / "first");
  EXPECT_EQ(Complaint(config), "none");
  config.start = (folder_.path() / "first/weights.safetensors").string();
  config.out = folder_.path() / "second";
  config.model.pair_features = 16;
  EXPECT_THAT(Complaint(config),
              AllOf(HasSubstr("weights.safetensors"), HasSubstr("of another shape")));
  config.start = (folder_.path() / "none.safetensors").string();
  EXPECT_THAT(Complaint(config), HasSubstr("none.safetensors"));
}

TEST_F(TrainNtsTest, RefusesToGoOnByAnotherConfig) {
  TrainConfig config = TinyConfig(folder_.path());
  EXPECT_EQ(Complaint(config), "none");
  config.seed = 1;
  EXPECT_THAT(Complaint(config), HasSubstr("another config"));
}

/// Depths that are no numbers from batch 6 on, of the fourth step.
class PoisonedSource : public BarSource {
 public:
  using BarSource::BarSource;
  PairBatch Batch(std::uint64_t number) const override {
    PairBatch batch = BarSource::Batch(number);
    if (number >= 6) batch.depth[0] = std::numeric_limits<float>::quiet_NaN();
    return batch;
  }
};

TEST_F(TrainNtsTest, StopsAtALossThatIsNoNumberAndKeepsTheCheckpoint) {
  const TrainConfig config = TinyConfig(folder_.path());
  Watcher watcher;
  try {
    RunTraining(tests::JobOn<NtsTraining, BarSource, PoisonedSource>(config), &watcher);
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("nan at step 4"));
    EXPECT_THAT(e.what(), HasSubstr("checkpoint.safetensors"));
  }
  Train(config, &watcher);
  EXPECT_EQ(watcher.resumed(), 2);
}

TEST_F(TrainNtsTest, SaysWhenItCannotWrite) {
  const TrainConfig config = TinyConfig(folder_.Write("file", "") / "out");
  EXPECT_THAT(Complaint(config), HasSubstr("file"));
}

TEST_F(TrainNtsTest, LogTellsTheLosses) {
  const TrainConfig config = TinyConfig(folder_.path());
  std::ostringstream out;
  const TrainJob job = tests::JobOn<NtsTraining, BarSource>(config);
  TrainingLog log(job, &out);
  RunTraining(job, &log);
  EXPECT_THAT(out.str(), HasSubstr("validation at step 6: loss "));
}

}  // namespace
}  // namespace bulletnav::bench
