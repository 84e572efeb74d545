// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "agent/policy/exploration_policy.h"
#include "benchmark/training/rl/exploration/exploration_scenes.h"
#include "benchmark/training/rl/exploration/map_simulator.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Episodes in which an exploration policy is tried, its goals drawn as in training. The same for
/// any number of threads.
class ExplorationValidation {
 public:
  /// The first `episodes` of the scenes, each in turn, which must outlive it.
  ExplorationValidation(const ExplorationScenes* scenes, const MapSimulatorSpec& spec,
                        int episodes);

  struct Result {
    double explored = 0.0;    // m2 of an episode, on the true map
    double early = 0.0;       // what was seen by a quarter of its steps is worth, m2
    double collisions = 0.0;  // of an episode
  };
  /// Makes a policy, once an episode, in any thread.
  using PolicyMaker = std::function<std::shared_ptr<agent::ExplorationPolicy>()>;
  Result Measure(const PolicyMaker& make, sim::WorkerPool* pool) const;
  /// The same episodes with goals anywhere in the window, or to the nearest frontiers.
  Result MeasureRandomGoals(sim::WorkerPool* pool) const;
  Result MeasureFrontiers(sim::WorkerPool* pool) const;

  /// What the policy is shown in the first `episodes` of them, for scales of integers: views of
  /// kExplorationBytes each.
  std::vector<std::uint8_t> Views(const PolicyMaker& make, int episodes) const;

 private:
  /// Walks to a goal.
  using Walk = std::function<void(MapSimulator*, sim::Rng*)>;
  Result Play(int number, const Walk& walk) const;
  Result MeanOf(const std::function<Walk()>& make, sim::WorkerPool* pool) const;

  const ExplorationScenes* scenes_;
  MapSimulatorSpec spec_;
  int episodes_;
};

}  // namespace bulletnav::bench
