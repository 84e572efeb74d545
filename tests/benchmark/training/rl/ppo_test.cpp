// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo.h"

#include <array>
#include <filesystem>

#include <gmock/gmock.h>

#include "agent/models/safetensors.h"
#include "benchmark/training/core/registry.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

/// Ends a training after a step, as a kill would.
struct Killed {};
class Watcher final : public TrainObserver {
 public:
  explicit Watcher(int kill_at) : kill_at_(kill_at) {}
  void Resumed(int step) override { resumed = step; }
  void Stepped(int step, double /*loss*/) override {
    if (step == kill_at_) throw Killed();
  }
  void Validated(int /*step*/, const Measures& /*measures*/, const std::string& /*text*/) override {
  }
  int resumed = 0;

 private:
  int kill_at_;
};

/// Episodes of lane + 2 steps, ended and cut in turn; seen is the step's number.
class Counting final : public PolicyTask {
 public:
  int lanes() const override { return 4; }
  int actions() const override { return 3; }
  int observation_size() const override { return 1; }
  void Begin(int lane, std::uint64_t episode) override {
    at_[static_cast<std::size_t>(lane)] = {0, episode};
  }
  void Observe(std::span<float> out) const override {
    for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<float>(at_[i].first);
  }
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool over = ++at_[i].first >= static_cast<int>(i) + 2;
      const bool cut = at_[i].second % 2 == 1;
      outcomes[i] = {static_cast<double>(actions[i]), over && !cut, over && cut, 0.0};
    }
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

TEST(Ppo, ASequenceIsWhatItsStepsWereAcrossEpisodes) {
  Counting task;
  PolicyNet net({16, true}, 1, 3, 7);
  Actor actor(&task, &net, 7);
  actor.Play(5, {});  // the hidden state that the next one begins with is not zero
  const Rollout rollout = actor.Play(12, {});
  EXPECT_GT(rollout.hidden.abs().sum().item<double>(), 0.0);
  EXPECT_GT(rollout.starts.sum().item<double>(), 8.0);
  const PolicyNet::Output again = net.Run(rollout.observations, rollout.starts, rollout.hidden);
  const torch::Tensor chosen =
      again.log_probabilities.gather(-1, rollout.actions.unsqueeze(-1)).squeeze(-1);
  EXPECT_LT((chosen - rollout.log_probabilities).abs().max().item<double>(), 1e-5);
  // It would not be if memory went on from one episode to the next.
  const PolicyNet::Output leaking =
      net.Run(rollout.observations, torch::zeros_like(rollout.starts), rollout.hidden);
  EXPECT_GT((leaking.values - again.values).abs().max().item<double>(), 1e-3);
}

TEST(Ppo, BeginsWithTheRatioOne) {
  Counting task;
  PolicyNet net({16, true}, 1, 3, 7);
  Actor actor(&task, &net, 7);
  actor.Play(5, {});
  RunningMoments moments;
  NoOptimiser optimiser;
  PpoSpec spec;
  spec.lanes = 4;
  const PpoReport report =
      LearnFrom(actor.Play(12, moments), spec, {&optimiser, 0.0, 1}, &net, &moments);
  EXPECT_LT(report.first_ratio_error, 1e-3);
  EXPECT_EQ(report.first_clip_fraction, 0.0);
  EXPECT_EQ(moments.count, 48.0);
}

TEST(Ppo, ActionsAreAFunctionOfTheirKeyWithTheProbabilitiesAsked) {
  const std::array<float, 2> log_probabilities = {std::log(0.25F), std::log(0.75F)};
  int ones = 0;
  for (std::uint64_t step = 0; step < 4000; ++step) {
    const int action = SampleAction({1, 2, 3, step}, log_probabilities);
    EXPECT_EQ(action, SampleAction({1, 2, 3, step}, log_probabilities));
    ones += action;
  }
  EXPECT_NEAR(ones / 4000.0, 0.75, 0.03);
}

TEST(Ppo, LanesThatCannotBeSharedOutAreRefused) {
  PpoSpec spec;
  spec.minibatches = 3;
  EXPECT_THROW(spec.Validate(), sim::Error);
}

TEST(Ppo, OnlyFirstEpisodesAreScored) {
  Counting task;
  PolicyNet net({16, true}, 1, 3, 7);
  Actor actor(&task, &net, 7);
  EXPECT_EQ(actor.Play(4, {}).first_scores.size(), 3U);
  EXPECT_EQ(actor.Play(12, {}).first_scores.size(), 1U);
}

TrainJob FourRooms(const std::filesystem::path& out) {
  const std::string text = "task: four_rooms\nout: " + out.string() +
                           "\nppo: {lanes: 8, rollout: 16, epochs: 2, minibatches: 2}\n"
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
  EXPECT_EQ(rest.resumed, 8);
  const auto weights = [&](const char* name) {
    return agent::ReadTensorFile(folder.path() / name / "weights.safetensors").tensors;
  };
  EXPECT_EQ(weights("whole"), weights("parts"));
}

}  // namespace
}  // namespace bulletnav::bench
