// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// When an episode counts as a success.
struct SuccessRule {
  double distance = 1.0;  // metres; nearer than this
  /// The "no stop" condition: being near is enough, at any step, and a stop does nothing. Else the
  /// agent must stop there.
  bool no_stop = false;
};

/// What one goal of an episode came to.
/// Source: success, SPL: Anderson et al., "On evaluation of embodied navigation agents", 2018;
/// SoftSPL: Datta et al., "Integrating egocentric localization for more realistic point-goal
/// navigation agents", 2020; 1 m, geodesic: Neural Topological SLAM.
struct GoalMetrics {
  bool success = false;
  bool success_euclidean = false;   // by the straight line: stops behind a wall count too
  double spl = 0.0;                 // success * d0 / max(d0, L); 1 for a success with d0 = L = 0
  double soft_spl = 0.0;            // max(0, 1 - d / d0) * d0 / max(d0, L)
  double start_distance = 0.0;      // d0: geodesic metres from start to goal
  double distance_to_goal = 0.0;    // d: geodesic metres at the end; infinite off the goal's island
  double euclidean_distance = 0.0;  // metres at the end
  double path_length = 0.0;         // L: metres really moved
  int steps = 0;
  int collisions = 0;

  bool operator==(const GoalMetrics&) const = default;
};

/// What happened on the way to one goal.
struct GoalRecord {
  double start_distance = 0.0;  // geodesic; finite and not negative (checked)
  double distance_to_goal = 0.0;
  double euclidean_distance = 0.0;
  double path_length = 0.0;
  bool stopped = false;  // the agent said so, before the steps ran out
  int steps = 0;
  int collisions = 0;
};

/// The metrics of a finished goal.
GoalMetrics Measure(const GoalRecord& record, const SuccessRule& rule);

/// Watches a body on its way to one goal. Give it every true position, the first included; under
/// `no_stop` the goal is over as soon as Reached() says so.
class GoalWatch {
 public:
  /// The query must outlive the watch. Throws sim::Error if no way leads from start to goal.
  GoalWatch(const sim::NavmeshQuery& query, const Eigen::Vector3d& start,
            const Eigen::Vector3d& goal, const SuccessRule& rule);

  /// One step further: where the body is now and whether it met something.
  void Step(const Eigen::Vector3d& position, bool collided);
  /// Whether the body is near the goal now. Cost: one geodesic if the straight line is short.
  bool Reached() const;
  /// Metres of way left from where the body now is.
  double Geodesic() const;
  GoalMetrics Finish(bool stopped) const;

 private:
  const sim::NavmeshQuery& query_;
  Eigen::Vector3d position_;
  Eigen::Vector3d goal_;
  SuccessRule rule_;
  GoalRecord record_;
};

}  // namespace bulletnav::bench
