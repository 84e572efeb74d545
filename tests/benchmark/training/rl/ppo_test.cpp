// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <vector>

#include <gmock/gmock.h>

#include "agent/models/safetensors.h"
#include "benchmark/training/core/adam.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/number_net.h"
#include "benchmark/training/rl/ppo_training.h"
#include "sim/base/error.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using tests::Killed;
using tests::Watcher;

/// Episodes of lane + 2 steps, ended and cut in turn; seen is the step's number.
class Counting final : public PolicyTask {
 public:
  int lanes() const override { return 4; }
  int actions() const override { return 3; }
  int observation_size() const override { return 1; }
  void Begin(int lane, std::uint64_t episode) override {
    at_[static_cast<std::size_t>(lane)] = {0, episode};
  }
  void Observe(std::span<float> out, std::span<std::uint8_t> /*pictures*/) override {
    for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<float>(at_[i].first);
  }
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool over = ++at_[i].first >= static_cast<int>(i) + 2;
      const bool cut = at_[i].second % 2 == 1;
      outcomes[i] = {static_cast<double>(actions[i]), over && !cut, over && cut, 0.0, over};
    }
  }
  bool Teach(std::span<Lesson> lessons) override {
    for (std::size_t i = 0; i < 4; ++i) lessons[i] = {at_[i].first % 3, at_[i].first != 1};
    return true;
  }
  std::vector<float> State() const override { return {}; }
  void SetState(std::span<const float> /*state*/) override {}

 private:
  std::array<std::pair<int, std::uint64_t>, 4> at_;
};

/// Does not move.
class NoOptimiser final : public Optimiser {
 public:
  void Step(double /*rate*/) override {}
  void Append(agent::TensorFile* /*content*/) const override {}
  void Set(const agent::TensorFile& /*content*/, const std::filesystem::path& /*file*/) override {}
};

/// A net on Counting, and who plays it.
struct Played {
  explicit Played(int threads = 1, int group = 2)
      : pool(threads),
        groups(
            4, group,
            [] {
              return std::make_unique<NumberNet>(NumberNetSpec{16, true}, 1, 3, 7);
            },
            &net, &pool),
        actor(&task, &net, &pool, group, 7) {}

  Rollout Play(int steps) {
    PlaySpec play;
    play.steps = steps;
    return actor.Play(play, {});
  }

  Counting task;
  NumberNet net{{16, true}, 1, 3, 7};
  sim::WorkerPool pool;
  LaneGroups groups;
  Actor actor;
};

TEST(Rollout, ThatDoesNotFitIntoMemoryIsRefusedBeforeItIsPlayed) {
  Played played;
  try {
    played.Play(2'000'000'000);  // steps of four lanes: 800 GB
    FAIL();
  } catch (const sim::Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("a rollout of 2000000000 steps in 4 lanes takes"));
  }
}

TEST(Rollout, ATeacherActsWhereItsLessonsDoNotCount) {
  Played played;
  PlaySpec play;
  play.steps = 7;
  play.lessons = true;
  play.taught_episodes = 1.0;
  play.values = false;
  const Rollout rollout = played.actor.Play(play, {});
  const torch::Tensor at = rollout.numbers.squeeze(-1).to(torch::kInt64);  // steps of episodes
  EXPECT_TRUE(at::equal(rollout.actions, at % 3));
  EXPECT_TRUE(at::equal(rollout.lessons, (at % 3).masked_fill(at == 1, kNoLesson)));
  EXPECT_GT((at == 1).sum().item<std::int64_t>(), 4);
}

TEST(Rollout, KnowsTheReturnsOfEpisodesThatEnded) {
  Played played;
  std::array<double, 4> now = {};  // of the episodes that are played, over all rollouts
  for (int rollouts = 0; rollouts < 3; ++rollouts) {
    const Rollout rollout = played.Play(7);
    std::vector<double> expected(8);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      for (const LaneStep& step : rollout.steps[lane]) {
        now[lane] += step.reward;
        if (!step.terminated && !step.truncated) continue;
        expected[2 * lane] += now[lane];
        expected[2 * lane + 1] += 1.0;
        now[lane] = 0.0;
      }
    }
    // A checkpoint keeps them.
    played.actor.SetState(played.actor.State(), played.actor.hidden());
    EXPECT_EQ(played.actor.TakeReturns(), expected);
    EXPECT_EQ(played.actor.TakeReturns()[1], 0.0);
  }
}

torch::Tensor AllLanes() {
  return torch::arange(0, 4, torch::kInt64);
}

TEST(Ppo, ASequenceIsWhatItsStepsWereAcrossEpisodes) {
  Played played;
  played.Play(5);  // the hidden state that the next one begins with is not zero
  const Rollout rollout = played.Play(12);
  EXPECT_GT(rollout.hidden.abs().sum().item<double>(), 0.0);
  EXPECT_GT(rollout.starts.sum().item<double>(), 8.0);
  const ActorCritic::Seen seen = rollout.SeenBy(&played.net, AllLanes());
  const ActorCritic::Output again = played.net.Run(seen, rollout.starts, rollout.hidden);
  const torch::Tensor chosen =
      again.log_probabilities.gather(-1, rollout.actions.unsqueeze(-1)).squeeze(-1);
  EXPECT_LT((chosen - rollout.log_probabilities).abs().max().item<double>(), 1e-5);
  // It would not be if memory went on from one episode to the next.
  const ActorCritic::Output leaking =
      played.net.Run(seen, torch::zeros_like(rollout.starts), rollout.hidden);
  EXPECT_GT((leaking.values - again.values).abs().max().item<double>(), 1e-3);
}

PpoReport Learn(Played* played, RunningMoments* moments) {
  NoOptimiser optimiser;
  PpoSpec spec;
  spec.lanes = 4;
  spec.group = 2;
  const Rollout rollout = played->Play(12);
  return LearnFrom(rollout, spec, {&optimiser, 0.0, 1}, &played->groups, &played->net, moments);
}

TEST(Ppo, BeginsWithTheRatioOne) {
  Played played;
  played.Play(5);
  RunningMoments moments;
  const PpoReport report = Learn(&played, &moments);
  EXPECT_LT(report.first_ratio_error, 1e-3);
  EXPECT_EQ(report.first_clip_fraction, 0.0);
  EXPECT_EQ(moments.count, 48.0);
}

TEST(Ppo, GradientsAreTheSameForAnyNumberOfThreads) {
  std::vector<torch::Tensor> gradients;
  for (const int threads : {1, 3}) {
    Played played(threads);
    RunningMoments moments;
    Learn(&played, &moments);
    gradients.push_back(played.net.parameters().front().grad().clone());
  }
  EXPECT_GT(gradients[0].abs().sum().item<double>(), 0.0);
  EXPECT_TRUE(at::equal(gradients[0], gradients[1]));
}

TEST(Ppo, ValueAloneLeavesThePolicyWithoutGradients) {
  Played played;
  RunningMoments moments;
  NoOptimiser optimiser;
  PpoSpec spec;
  spec.lanes = 4;
  spec.group = 2;
  const Rollout rollout = played.Play(12);
  LearnFrom(rollout, spec, {&optimiser, 0.0, 1, true}, &played.groups, &played.net, &moments);
  int of_value = 0;
  for (const auto& parameter : played.net.named_parameters()) {
    const torch::Tensor gradient = parameter.value().grad();
    const bool has_gradient = gradient.defined() && gradient.abs().sum().item<double>() > 0.0;
    EXPECT_EQ(gradient.defined(), has_gradient) << parameter.key();
    EXPECT_EQ(has_gradient, ActorCritic::IsOfValue(parameter.key())) << parameter.key();
    of_value += has_gradient ? 1 : 0;
  }
  EXPECT_EQ(of_value, 2);  // weight and bias
}

TEST(Ppo, ThePolicyWarmsUpAfterItsValue) {
  PpoPlan plan;
  plan.optimiser = {1.0, Schedule::kConstant, 4};
  for (const int step : {0, 2, 3, 50}) {
    EXPECT_EQ(plan.RateAt(step), std::min(1.0, (step + 1) / 4.0));
  }
  plan.ppo.value_first = 3;
  EXPECT_EQ(plan.RateAt(0), 0.25);
  EXPECT_EQ(plan.RateAt(2), 0.75);
  EXPECT_EQ(plan.RateAt(3), 0.25);
  EXPECT_EQ(plan.RateAt(5), 0.75);
  for (const int step : {6, 7, 50}) EXPECT_EQ(plan.RateAt(step), 1.0);
}

/// Without means of gradients from before, a first step of Adam is as long as the rate for all.
TEST(Ppo, WhatBeginsToLearnLaterDoesSoAsIfFromTheStart) {
  class Two final : public torch::nn::Module {
   public:
    torch::Tensor early = register_parameter("early", torch::zeros({2}));
    torch::Tensor late = register_parameter("late", torch::zeros({2, 3}));
  } net;
  OptimiserSpec spec;
  spec.epsilon = 1e-12;
  Adam adam(net, spec);
  for (int step = 0; step < 50; ++step) {
    net.early.mutable_grad() = torch::ones({2});
    adam.Step(0.01);
  }
  EXPECT_EQ(net.late.abs().sum().item<double>(), 0.0);
  net.late.mutable_grad() = torch::full({2, 3}, -3.0);
  adam.Step(0.01);
  EXPECT_TRUE(at::allclose(net.late.detach(), torch::full({2, 3}, 0.01), 1e-4, 1e-6));
}

TEST(Ppo, ActionsAreAFunctionOfTheirKeyWithTheProbabilitiesAsked) {
  const NumberNet net({}, 1, 2, 0);
  const std::array<float, 2> log_probabilities = {std::log(0.25F), std::log(0.75F)};
  int ones = 0;
  for (std::uint64_t step = 0; step < 4000; ++step) {
    const int action = SampleAction({1, 2, 3, step}, net, log_probabilities);
    EXPECT_EQ(action, SampleAction({1, 2, 3, step}, net, log_probabilities));
    ones += action;
  }
  EXPECT_NEAR(ones / 4000.0, 0.75, 0.03);
}

TEST(Ppo, LanesThatCannotBeSharedOutAreRefused) {
  PpoSpec spec;
  spec.minibatches = 3;
  EXPECT_THROW(spec.Validate(), sim::Error);
  PpoSpec groups;
  groups.group = 5;
  EXPECT_THROW(groups.Validate(), sim::Error);
  PpoSpec entropy;
  entropy.entropy = -1.0;
  EXPECT_THROW(entropy.Validate(), sim::Error);
  PpoSpec value;
  value.value = 1e38;
  EXPECT_THROW(value.Validate(), sim::Error);
}

TEST(LaneGroups, EachMinibatchHasOneOfEachNeighbours) {
  constexpr int kGroups = 12;
  constexpr int kCount = 3;
  sim::Rng rng(5, "minibatches");
  std::set<std::vector<int>> drawn;
  for (int epoch = 0; epoch < 20; ++epoch) {
    std::vector<int> all;
    for (const std::vector<int>& minibatch : DrawMinibatches(kGroups, kCount, &rng)) {
      ASSERT_EQ(minibatch.size(), kGroups / kCount);
      for (int i = 0; i < kGroups / kCount; ++i) {
        EXPECT_EQ(minibatch[static_cast<std::size_t>(i)] / kCount, i);
      }
      all.insert(all.end(), minibatch.begin(), minibatch.end());
      drawn.insert(minibatch);
    }
    std::ranges::sort(all);
    for (int i = 0; i < kGroups; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], i);
  }
  EXPECT_GT(drawn.size(), 20U);  // epochs differ
  const std::vector<std::vector<int>> whole = {{0, 1, 2, 3}};
  EXPECT_EQ(DrawMinibatches(4, 1, &rng), whole);
}

TEST(Ppo, EpisodesThatEndAreTold) {
  Played played;
  const std::vector<EndedEpisode> ended = played.Play(4).ended;
  ASSERT_EQ(ended.size(), 4U);  // of 2, 3, 4 steps, and the first lane's second
  EXPECT_EQ(ended[0].lane, 0);
  EXPECT_EQ(ended[0].steps, 2U);
  EXPECT_TRUE(ended[0].success);
  EXPECT_EQ(played.Play(1).ended.size(), 1U);
}

TrainJob FourRooms(const std::filesystem::path& out) {
  const std::string text = "task: four_rooms\nout: " + out.string() +
                           "\nppo: {lanes: 8, group: 2, rollout: 16, epochs: 2, minibatches: 2}\n"
                           "model: {width: 16}\nsteps: 12\nvalidate_every: 4\n"
                           "validation_steps: 20\n";
  return MakeTraining(sim::ParseYaml(text, "rooms.yaml"), "nts", {});
}

TEST(PpoTraining, ResumedIsTheSameAsUninterruptedBitForBit) {
  const tests::TemporaryFolder folder;
  Watcher whole(0);
  RunTraining(FourRooms(folder.path() / "whole"), &whole);
  for (const int kill_at : {6, 11}) {
    Watcher killed(kill_at);
    EXPECT_THROW(RunTraining(FourRooms(folder.path() / "parts"), &killed), Killed);
  }
  Watcher rest(0);
  RunTraining(FourRooms(folder.path() / "parts"), &rest);
  EXPECT_EQ(rest.resumed(), 8);
  const auto weights = [&](const char* name) {
    return agent::ReadTensorFile(folder.path() / name / "weights.safetensors").tensors;
  };
  EXPECT_EQ(weights("whole"), weights("parts"));
}

}  // namespace
}  // namespace bulletnav::bench
