// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "agent/policy/policy_model.h"
#include "agent/policy/quantise_policy.h"
#include "benchmark/play/environment.h"
#include "benchmark/training/core/measures.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Episodes that a policy is tried in, as runs play them: the agent with its policy, one body, the
/// whole panorama.
class PolicyValidation {
 public:
  /// The first `episodes` of the scenes, each in turn.
  PolicyValidation(NavigationScenes* scenes, const Task& task, int episodes);

  /// Success and SPL of all episodes and of each kind, steps of an episode, share of episodes that
  /// ended by a stop. `prefix` comes before the names. The same for any number of threads.
  /// `make`: the policy, once an episode, in any thread.
  using PolicyMaker = std::function<std::shared_ptr<agent::PolicyModel>()>;
  void Measure(const PolicyMaker& make, bool with_depth, const std::string& prefix,
               sim::WorkerPool* pool, Measures* measures) const;

  /// What policies see at the starts of the episodes and on the shortest ways from there, for
  /// scales of integers.
  agent::PolicyCalibration Calibration(int rows, bool with_depth) const;

 private:
  struct Result {
    Difficulty kind = Difficulty::kEasy;
    double success = 0.0;
    double spl = 0.0;
    double steps = 0.0;
    double stopped = 0.0;
  };
  Result Play(const NavigationScenes::Drawn& drawn, bool with_depth, const PolicyMaker& make) const;

  Task task_;
  std::vector<NavigationScenes::Drawn> episodes_;
};

}  // namespace bulletnav::bench
