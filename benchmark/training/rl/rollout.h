// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "benchmark/training/rl/gae.h"
#include "benchmark/training/rl/policy_net.h"
#include "benchmark/training/rl/policy_task.h"
#include "benchmark/training/rl/running_moments.h"

namespace bulletnav::bench {

/// What was seen and done in all lanes; tensors [steps, lanes, ...].
struct Rollout {
  torch::Tensor observations;
  torch::Tensor starts;
  torch::Tensor actions;
  torch::Tensor log_probabilities;           // of the actions, when they were chosen
  torch::Tensor hidden;                      // [lanes, width], before the first step
  std::vector<std::vector<LaneStep>> steps;  // [lanes][steps]
  std::vector<double> last_values;           // [lanes], after the last step
  std::vector<double> first_scores;  // of the lanes' first episodes, as far as they ended here
};

/// The action of a step: a function of its key and the policy's probabilities.
struct ActionKey {
  std::uint64_t seed = 0;
  int lane = 0;
  std::uint64_t episode = 0;
  std::uint64_t step = 0;  // of the episode
};
/// `log_probabilities`: of all actions.
int SampleAction(const ActionKey& key, std::span<const float> log_probabilities);

/// Plays lanes by a policy, from one rollout to the next.
class Actor {
 public:
  /// `task` and `net` must outlive it. Begins the first episodes.
  Actor(PolicyTask* task, PolicyNet* net, std::uint64_t seed);

  /// `moments`: of returns, that the net's values are normalised by.
  Rollout Play(int steps, const RunningMoments& moments);

  /// Episodes, steps, starts and memory of the lanes; the task has its own state.
  torch::Tensor hidden() const { return hidden_; }
  std::vector<float> State() const;
  void SetState(const std::vector<float>& state, const torch::Tensor& hidden);

 private:
  torch::Tensor Observed() const;
  void Act(const PolicyNet::Output& output, std::vector<int>* actions) const;
  std::vector<double> ValuesHere(const torch::Tensor& starts, const RunningMoments& moments);
  void BeginOver(const std::vector<LaneOutcome>& outcomes);

  PolicyTask* task_;
  PolicyNet* net_;
  std::uint64_t seed_;
  torch::Tensor hidden_;
  torch::Tensor starts_;  // [lanes]
  std::vector<std::uint64_t> episodes_;
  std::vector<std::uint64_t> steps_;
};

}  // namespace bulletnav::bench
