// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "benchmark/training/core/peers.h"
#include "benchmark/training/rl/actor_critic.h"
#include "sim/math/rng.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Always the same net.
using ActorCriticMaker = std::function<std::unique_ptr<ActorCritic>()>;

/// The lanes of a training that a process plays and learns from.
struct LaneShare {
  int lanes = 0;
  int first = 0;  // of all lanes
};

/// `lanes` of all processes, in groups, of which each of some minibatches has as many; `peers`:
/// null is alone. Throws Error, with the remedy, unless each process can have as many groups of
/// each minibatch and processes are 1, 2, 4, 8 and so on: sums over groups are then the same for
/// all.
LaneShare ShareOf(int lanes, int group, int minibatches, const Peers* peers);

/// The groups of each minibatch of an epoch, ascending, drawn so that of each `count` neighbours
/// one is in each: processes that share the groups have as many of each. Expects: `count` divides
/// `groups` (checked).
std::vector<std::vector<int>> DrawMinibatches(int groups, int count, sim::Rng* rng);

/// Throws KeyError of the key in question unless groups of `group` divide `lanes`, and
/// `minibatches` the groups.
void RequireGroups(int lanes, int group, int minibatches);

/// Lanes are learned from in groups, which threads and processes take side by side. Each group has
/// the parameters of the trained net and gradients of its own, which are added up as a binary tree
/// over the groups: what an update comes to depends on the size of groups, and neither on the
/// number of threads nor on that of processes.
class LaneGroups {
 public:
  /// `lanes` of all processes in groups of `group`, which must divide them (checked). `net`, `pool`
  /// and `peers` must outlive it; the net's parameters stay where they are.
  LaneGroups(int lanes, int group, const ActorCriticMaker& make, ActorCritic* net,
             sim::WorkerPool* pool, Peers* peers = nullptr);

  int groups() const { return groups_; }  // of all processes
  /// Those of some groups that are this process's.
  std::vector<int> Own(const std::vector<int>& groups) const;
  /// The lanes of a group among this process's, i64. Expects: its own (checked).
  torch::Tensor LanesOf(int group) const;

  /// Calls `loss` for some groups, each process for its own, forth and back; the net's gradients
  /// become the means over all. Returns the loss of each, in their order. `groups`: ascending, and
  /// as ShareOf says.
  using GroupLoss = std::function<torch::Tensor(int group, ActorCritic* net)>;
  std::vector<double> Differentiate(const std::vector<int>& groups, const GroupLoss& loss);

  /// Numbers of own lanes or groups, as many for each: those of all, in order.
  std::vector<double> Gather(std::span<const double> own);

 private:
  ActorCritic* NetOf(int group) const {
    return nets_[static_cast<std::size_t>(group - first_)].get();
  }
  void TakeSum(ActorCritic* summed, double share);

  int group_;
  int groups_;
  int first_;  // own group
  ActorCritic* net_;
  sim::WorkerPool* pool_;
  Peers* peers_;  // null: alone
  std::vector<std::unique_ptr<ActorCritic>> nets_;
};

/// Scales the gradients so that their norm is at most `limit`. Returns the norm before.
double LimitGradients(const torch::nn::Module& net, double limit);

}  // namespace bulletnav::bench
