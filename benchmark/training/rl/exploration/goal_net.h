// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/policy/exploration_net.h"
#include "benchmark/training/rl/actor_critic.h"

namespace bulletnav::bench {

/// An exploration policy as it is trained. Its actions are goals (see ActionOf), drawn from two
/// normal distributions; what it says of a step is their means and the logarithms of their
/// deviations.
class GoalNet final : public ActorCritic {
 public:
  /// `learns_deviation`: else it is set from outside; see SetDeviation.
  GoalNet(const agent::ExplorationConfig& config, bool learns_deviation, std::uint64_t seed);

  torch::Tensor Encode(const torch::Tensor& pictures) override { return net_->Encode(pictures); }
  bool learns_to_see() const override { return true; }
  Output Run(const Seen& seen, const torch::Tensor& starts, const torch::Tensor& hidden) override;
  torch::Tensor NoMemory(int lanes) const override { return torch::zeros({lanes, 1}); }

  int Draw(std::span<const float> said, sim::Rng* rng) const override;
  torch::Tensor LogProbabilitiesOf(const Output& output,
                                   const torch::Tensor& actions) const override;
  torch::Tensor EntropyOf(const Output& output) const override;

  /// Of both numbers.
  void SetDeviation(double deviation);

  const std::shared_ptr<agent::ExplorationNet>& policy() const { return net_; }

 private:
  bool learns_deviation_;
  std::shared_ptr<agent::ExplorationNet> net_;
};

}  // namespace bulletnav::bench
