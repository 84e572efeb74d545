// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "benchmark/training/rl/actor_critic.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Always the same net.
using ActorCriticMaker = std::function<std::unique_ptr<ActorCritic>()>;

/// Lanes are learned from in groups, which threads take side by side. Each group has the parameters
/// of the trained net and gradients of its own, so that what an update comes to depends on the size
/// of groups and not on the number of threads.
class LaneGroups {
 public:
  /// `lanes` in groups of `group`, which must divide it (checked). `net` and `pool` must outlive
  /// it; the net's parameters stay where they are.
  LaneGroups(int lanes, int group, const ActorCriticMaker& make, ActorCritic* net,
             sim::WorkerPool* pool);

  int groups() const { return static_cast<int>(nets_.size()); }
  /// The lanes of a group, i64.
  torch::Tensor LanesOf(int group) const;

  /// Calls `loss` for some groups, forth and back; the net's gradients become the means over them.
  /// Returns the loss of each, in their order.
  using GroupLoss = std::function<torch::Tensor(int group, ActorCritic* net)>;
  std::vector<double> Differentiate(const std::vector<int>& groups, const GroupLoss& loss);

 private:
  int group_;
  ActorCritic* net_;
  sim::WorkerPool* pool_;
  std::vector<std::unique_ptr<ActorCritic>> nets_;
};

/// Scales the gradients so that their norm is at most `limit`. Returns the norm before.
double LimitGradients(const torch::nn::Module& net, double limit);

}  // namespace bulletnav::bench
