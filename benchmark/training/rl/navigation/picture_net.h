// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "agent/policy/policy_net.h"
#include "benchmark/training/rl/actor_critic.h"

namespace bulletnav::bench {

/// An agent's policy as it is trained.
class PictureNet final : public ActorCritic {
 public:
  /// `encoder`: weights of a semantic model of the policy's rows, whose encoder it begins with, or,
  /// if it has none of its own, sees with; absent: random weights. Throws FileError.
  PictureNet(const agent::PolicyConfig& config, const std::optional<std::string>& encoder,
             std::uint64_t seed);

  torch::Tensor Encode(const torch::Tensor& pictures) override;
  bool learns_to_see() const override { return policy_->config().own_encoder; }
  Output Run(const Seen& seen, const torch::Tensor& starts, const torch::Tensor& hidden) override;
  torch::Tensor NoMemory(int lanes) const override;

  /// From now on it sees colour alone, whatever it is shown.
  void HideDepth() { hides_depth_ = true; }

  /// From now on it stops as its agent does, see PolicyAgent::Config. For imitation only: what is
  /// drawn is then not the policy's distribution.
  void StopFrom(double probability) { stop_from_ = probability; }
  int Draw(std::span<const float> log_probabilities, sim::Rng* rng) const override;

  const std::shared_ptr<agent::PolicyNet>& policy() const { return policy_; }

 private:
  std::shared_ptr<agent::PolicyNet> policy_;
  bool hides_depth_ = false;
  double stop_from_ = 0.0;
};

}  // namespace bulletnav::bench
