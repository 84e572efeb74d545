// SPDX-License-Identifier: MIT
#include "benchmark/report/goal_ends.h"

#include <algorithm>

namespace bulletnav::bench {

std::vector<GoalEnd> GoalEnds(const EpisodeTrajectory& trajectory) {
  const auto& steps = trajectory.steps;
  const bool stops_count = trajectory.result.key.condition != "no_stop";
  std::vector<GoalEnd> ends;
  std::size_t at = 0;  // steps taken
  for (const GoalMetrics& goal : trajectory.result.goals) {
    if (at == steps.size() && !goal.success) break;
    at = std::min(at + static_cast<std::size_t>(goal.steps), steps.size());
    EndKind kind = goal.success ? EndKind::kReached : EndKind::kNoStop;
    // A stop is no step of its goal.
    if (stops_count && at < steps.size() && steps[at].action == sim::Action::kStop) {
      kind = goal.success ? EndKind::kStopAtGoal : EndKind::kStopElsewhere;
      ++at;
    }
    ends.push_back({kind, at == 0 ? trajectory.start : steps[at - 1].pose});
  }
  return ends;
}

}  // namespace bulletnav::bench
