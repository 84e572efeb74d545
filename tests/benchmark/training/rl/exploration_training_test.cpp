// SPDX-License-Identifier: MIT
// The exploration policy's training in a small building: that its net says what it should, and that
// it goes on as if it had not been killed.
#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/exploration/exploration_lanes.h"
#include "benchmark/training/rl/exploration/goal_net.h"
#include "sim/base/error.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;
using tests::Killed;
using tests::Watcher;

TEST(GoalNet, ProbabilitiesAreThoseOfTwoNormalNumbers) {
  GoalNet net({.features = 16, .heading_size = 2}, true, 1);
  const double mean[] = {0.5, -1.0};
  const double deviation[] = {0.5, 2.0};
  ActorCritic::Output output;
  output.log_probabilities =
      torch::tensor({mean[0], mean[1], std::log(deviation[0]), std::log(deviation[1])})
          .to(torch::kFloat32)
          .view({1, 1, 4});
  const agent::GoalSteps goal = {256, 64};  // 1 and 0.25
  const torch::Tensor actions = torch::full({1, 1}, ActionOf(goal), torch::kInt64);
  double expected = 0.0;
  double entropy = 0.0;
  for (int i = 0; i < 2; ++i) {
    const double off = (goal[static_cast<std::size_t>(i)] / 256.0 - mean[i]) / deviation[i];
    expected += -0.5 * off * off - std::log(deviation[i] * std::sqrt(2.0 * sim::kPi));
    entropy += std::log(deviation[i] * std::sqrt(2.0 * sim::kPi * std::exp(1.0)));
  }
  EXPECT_NEAR(net.LogProbabilitiesOf(output, actions).item<double>(), expected, 1e-5);
  EXPECT_NEAR(net.EntropyOf(output).item<double>(), entropy, 1e-5);
}

TEST(GoalNet, DrawsGoalsWithTheMomentsThatItSays) {
  const GoalNet net({.features = 16, .heading_size = 2}, true, 1);
  const std::array<float, 4> said = {0.5f, -1.0f, std::log(0.5f), 0.0f};
  double sums[2] = {0.0, 0.0};
  double squares[2] = {0.0, 0.0};
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    sim::Rng rng = sim::Rng(5, "draw").Fork("step", static_cast<std::uint64_t>(i));
    const agent::GoalSteps goal = GoalOf(net.Draw(said, &rng));
    for (std::size_t k = 0; k < 2; ++k) {
      const double off = goal[k] * agent::kGoalStep - double{said[k]};
      sums[k] += off / kDraws;
      squares[k] += off * off / kDraws;
    }
  }
  EXPECT_NEAR(sums[0], 0.0, 0.03);
  EXPECT_NEAR(sums[1], 0.0, 0.06);
  EXPECT_NEAR(std::sqrt(squares[0]), 0.5, 0.02);
  EXPECT_NEAR(std::sqrt(squares[1]), 1.0, 0.04);
}

class ExplorationTrainingTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new tests::TemporaryFolder();
    tests::WriteShellHouses(folder_->path() / "houses", 2, 1);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string Config(const std::string& out, const std::string& more) {
    const std::string index = (folder_->path() / "houses/index.json").string();
    return "task: exploration\nout: " + (folder_->path() / out).string() +
           "\ndata: {houses: {index: " + index +
           ", split: train}}\nvalidation: {houses: {index: " + index +
           ", split: test}}\nvalidation_episodes: 1\n"
           "simulator: {goal_steps: 4, episode_steps: 12}\n"
           "model: {features: 16, heading_size: 2, precision: float32}\n"
           "ppo: {lanes: 2, group: 1, rollout: 2, epochs: 1, minibatches: 2}\n"
           "steps: 3\nvalidate_every: 2\n" +
           more;
  }
  static TrainJob Job(const std::string& config) {
    return MakeTraining(sim::ParseYaml(config, "exploration.yaml"), "nts", {});
  }

  static tests::TemporaryFolder* folder_;
};

tests::TemporaryFolder* ExplorationTrainingTest::folder_ = nullptr;

TEST_F(ExplorationTrainingTest, GoesOnAfterAKillAsIfThereHadBeenNone) {
  const std::string more = "deviation: {from: 1.0, to: 0.5}\n";
  Watcher whole;
  RunTraining(Job(Config("whole", more)), &whole);
  EXPECT_NEAR(whole.measures().at("deviation"), 0.5, 1e-5);
  EXPECT_GT(whole.measures().at("explored_at_random"), 1.0);
  Watcher killed(3);
  EXPECT_THROW(RunTraining(Job(Config("parts", more)), &killed), Killed);
  Watcher rest;
  RunTraining(Job(Config("parts", more)), &rest);
  EXPECT_EQ(rest.resumed(), 2);
  const auto weights = [&](const char* name) {
    return agent::ReadTensorFile(folder_->path() / name / "weights.safetensors");
  };
  EXPECT_EQ(weights("whole").tensors, weights("parts").tensors);
  EXPECT_EQ(weights("whole").metadata.at("frames"), std::to_string(3 * 2 * 2 * 4));
  EXPECT_TRUE(agent::HoldsIntegers(weights("whole")));
  const auto model = agent::LoadModel(folder_->path() / "whole/weights.safetensors", {});
  EXPECT_NE(dynamic_cast<agent::ExplorationPolicy*>(model.get()), nullptr);
}

TEST_F(ExplorationTrainingTest, IsMadeLongerInItsFolderWhereNoStepHeedsTheirNumber) {
  const std::string constant = "optimiser: {schedule: constant, warmup_steps: 0}\n";
  const auto with_steps = [&](const std::string& out, int steps, const std::string& more) {
    std::string config = Config(out, more);
    config.replace(config.find("steps: 3"), 8, "steps: " + std::to_string(steps));
    return config;
  };
  Watcher watcher;
  RunTraining(Job(with_steps("at_once", 3, constant)), &watcher);
  RunTraining(Job(with_steps("longer", 2, constant)), &watcher);
  Watcher rest;
  RunTraining(Job(with_steps("longer", 3, constant)), &rest);
  EXPECT_EQ(rest.resumed(), 2);
  const auto weights = [&](const char* name) {
    return agent::ReadTensorFile(folder_->path() / name / "weights.safetensors");
  };
  EXPECT_EQ(weights("at_once").tensors, weights("longer").tensors);
  const auto expect = [&](int steps, const std::string& more, const char* what) {
    try {
      RunTraining(Job(with_steps("longer", steps, more)), &rest);
      FAIL() << what;
    } catch (const sim::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(what));
    }
  };
  expect(2, constant, "checkpoint.safetensors: is of step 3, beyond steps: 2");
  expect(4, "optimiser: {schedule: cosine, warmup_steps: 0}\n",
         "by another config: line 5 is '  schedule: constant' there and '  schedule: cosine' here");
}

TEST_F(ExplorationTrainingTest, BadConfigsAreRefusedWhereTheyAreWrong) {
  const auto expect = [&](const std::string& more, const char* what) {
    try {
      Job(Config("bad", more));
      FAIL() << what;
    } catch (const sim::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(what));
      EXPECT_THAT(e.what(), HasSubstr("exploration.yaml:"));
    }
  };
  expect("deviation: {from: 0}\n", "from must be in");
  expect("deviations: 1\n", "deviations");
}

}  // namespace
}  // namespace bulletnav::bench
