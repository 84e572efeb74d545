// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "agent/policy/policy_agent.h"
#include "agent/policy/policy_model.h"
#include "agent/policy/quantise_policy.h"
#include "benchmark/play/environment.h"
#include "benchmark/training/core/measures.h"
#include "benchmark/training/core/peers.h"
#include "benchmark/training/rl/navigation/navigation_lanes.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Episodes that a policy is tried in, as runs play them: the agent with its policy, one body, the
/// whole panorama.
class PolicyValidation {
 public:
  /// The first `episodes` of the scenes, each in turn.
  PolicyValidation(NavigationScenes* scenes, const Task& task, int episodes);

  /// How the episodes are played.
  struct Way {
    bool with_depth = false;
    std::string prefix;  // before the names of measures
    sim::WorkerPool* pool = nullptr;
    Peers* peers = nullptr;      // share the episodes; null: alone
    bool shuffle_goals = false;  // the panorama of another episode's goal is shown
    bool blank_images = false;   // nothing is seen
    /// Pictures are drawn at once with so many rows, and each pixel shown as a square of a whole
    /// panorama's: what training by DrawMode::kDirect shows (but for maps, which are made of the
    /// enlarged pictures here). 0: whole panoramas are drawn. Expects: a divisor of the task's rows
    /// (checked).
    int direct_rows = 0;
    agent::PolicyAgent::Config agent = {};
  };
  /// Success and SPL of all episodes and of each kind, steps of an episode, share of episodes that
  /// ended by a stop. The same for any number of threads and processes. `make`: the policy, once an
  /// episode, in any thread.
  using PolicyMaker = std::function<std::shared_ptr<agent::PolicyModel>()>;
  void Measure(const PolicyMaker& make, const Way& way, Measures* measures) const;

  /// What policies see at the starts of the episodes and on the shortest ways from there, for
  /// scales of integers; in both settings one after the other.
  agent::PolicyCalibration Calibration(const agent::PolicyConfig& config,
                                       LaneSetting setting) const;

 private:
  struct Result {
    Difficulty kind = Difficulty::kEasy;
    double success = 0.0;
    double spl = 0.0;
    double steps = 0.0;
    double stopped = 0.0;
  };
  class Picture;
  Picture GoalOf(std::size_t number, const Task& task) const;
  Picture Shown(const agent::Panorama& panorama, const Way& way) const;
  Result Play(std::size_t number, const Way& way, const PolicyMaker& make) const;
  std::vector<Result> PlayAll(const Way& way, const PolicyMaker& make) const;

  Task task_;
  std::vector<NavigationScenes::Drawn> episodes_;
};

}  // namespace bulletnav::bench
