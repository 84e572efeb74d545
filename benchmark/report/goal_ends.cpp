// SPDX-License-Identifier: MIT
#include "benchmark/report/goal_ends.h"

#include <algorithm>

#include "benchmark/play/condition.h"

namespace bulletnav::bench {
namespace {

/// Under the condition "no_stop" a stop is a step that does nothing.
bool StopsCount(const EpisodeTrajectory& trajectory) {
  return trajectory.result.key.condition != sim::NameOf(Condition::kNoStop);
}

}  // namespace

std::vector<int> StepNumbers(const EpisodeTrajectory& trajectory) {
  std::vector<int> numbers = {0};
  for (const TrajectoryStep& step : trajectory.steps) {
    const bool is_end = StopsCount(trajectory) && step.action == sim::Action::kStop;
    numbers.push_back(numbers.back() + (is_end ? 0 : 1));
  }
  return numbers;
}

std::vector<GoalEnd> GoalEnds(const EpisodeTrajectory& trajectory) {
  const auto& steps = trajectory.steps;
  std::vector<GoalEnd> ends;
  std::size_t at = 0;  // steps taken
  for (const GoalMetrics& goal : trajectory.result.goals) {
    if (at == steps.size() && !goal.success()) break;
    at = std::min(at + static_cast<std::size_t>(goal.Whole("steps")), steps.size());
    EndKind kind = goal.success() ? EndKind::kReached : EndKind::kNoStop;
    // A stop is no step of its goal.
    if (StopsCount(trajectory) && at < steps.size() && steps[at].action == sim::Action::kStop) {
      kind = goal.success() ? EndKind::kStopAtGoal : EndKind::kStopElsewhere;
      ++at;
    }
    ends.push_back({kind, at == 0 ? trajectory.start : steps[at - 1].pose, at});
  }
  return ends;
}

}  // namespace bulletnav::bench
