// SPDX-License-Identifier: MIT
#include "benchmark/training/core/train_lanes.h"

#include <gtest/gtest.h>

#include "benchmark/training/supervised/nts_trainer.h"
#include "tests/benchmark/training/supervised/bar_world.h"

namespace bulletnav::bench {
namespace {

TrainConfig Config(int scenes, int lanes) {
  TrainConfig config;
  config.model.width = 8;
  config.model.rows = 32;
  config.model.pair_features = 16;
  config.scenes = scenes;
  config.lanes = lanes;
  config.panoramas = 4;
  config.pairs = 8;
  return config;
}

struct Passed {
  double loss = 0.0;
  std::vector<torch::Tensor> gradients;
  std::vector<torch::Tensor> means;
};

Passed PassSteps(const TrainConfig& config, int threads, int steps = 1) {
  sim::WorkerPool pool(threads);
  const tests::BarSource source(config.panoramas, 3);
  const TrainTask task = NtsTask(config, {source, source});
  const std::unique_ptr<Learner> learner = task.make();
  torch::nn::Module& net = learner->net();
  TrainLanes lanes(task, &net, &pool);
  Passed passed;
  for (int step = 0; step < steps; ++step) passed.loss = lanes.Pass(step);
  for (const torch::Tensor& parameter : net.parameters()) {
    passed.gradients.push_back(parameter.grad());
  }
  passed.means = net.buffers();
  return passed;
}

TEST(TrainLanes, ThreadsDoNotChangeABit) {
  const Passed one = PassSteps(Config(4, 4), 1, 2);
  const Passed four = PassSteps(Config(4, 4), 4, 2);
  EXPECT_EQ(one.loss, four.loss);
  for (std::size_t i = 0; i < one.gradients.size(); ++i) {
    EXPECT_TRUE(at::equal(one.gradients[i], four.gradients[i])) << i;
  }
  for (std::size_t i = 0; i < one.means.size(); ++i) {
    EXPECT_TRUE(at::equal(one.means[i], four.means[i])) << i;
  }
}

TEST(TrainLanes, ScoreContrastCountsFromItsStepOn) {
  const TrainConfig plain = Config(1, 1);
  TrainConfig contrast = plain;
  contrast.score_contrast = {.weight = 50.0, .from_step = 1};
  EXPECT_EQ(PassSteps(contrast, 1, 1).loss, PassSteps(plain, 1, 1).loss);
  EXPECT_GT(PassSteps(contrast, 1, 2).loss, PassSteps(plain, 1, 2).loss);
}

TEST(TrainLanes, GradientsAreThoseOfTheMeanLoss) {
  // Batch 0 alone, then batches 0 and 1 in a lane each: batch 1 alone follows.
  const Passed first = PassSteps(Config(1, 1), 1);
  const Passed both = PassSteps(Config(2, 2), 1);
  sim::WorkerPool pool(1);
  const TrainConfig config = Config(1, 1);
  const tests::BarSource source(config.panoramas, 3);
  const TrainTask task = NtsTask(config, {source, source});
  const std::unique_ptr<Learner> learner = task.make();
  torch::nn::Module& net = learner->net();
  TrainLanes lanes(task, &net, &pool);
  const double second = lanes.Pass(1);
  EXPECT_NEAR(both.loss, 0.5 * (first.loss + second), 1e-6);
  const std::vector<torch::Tensor> parameters = net.parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const torch::Tensor mean = 0.5 * (first.gradients[i] + parameters[i].grad());
    EXPECT_TRUE(at::allclose(both.gradients[i], mean, 1e-4, 1e-6)) << i;
  }
}

}  // namespace
}  // namespace bulletnav::bench
