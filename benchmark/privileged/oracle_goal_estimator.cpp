// SPDX-License-Identifier: MIT
#include "benchmark/privileged/oracle_goal_estimator.h"

#include <cmath>

#include "benchmark/privileged/visibility.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {

std::optional<agent::RelativeGoal> OracleGoalEstimator::Estimate(const agent::Panorama& /*here*/,
                                                                 const agent::Panorama& /*goal*/) {
  if (!IsInNode(*truth_.world, truth_.body, truth_.pose, truth_.goal)) return std::nullopt;
  const sim::PlanarPose goal = sim::RelativePose(truth_.pose, truth_.goal);
  return agent::RelativeGoal{std::hypot(goal.x, goal.y), sim::Atan2(goal.y, goal.x)};
}

}  // namespace bulletnav::bench
