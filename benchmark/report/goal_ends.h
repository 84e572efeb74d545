// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/play/trajectory.h"

namespace bulletnav::bench {

/// Steps taken at the start and after each action, as results count them: a stop that ends the way
/// to a goal is none.
std::vector<int> StepNumbers(const EpisodeTrajectory& trajectory);

/// How the way to a goal came to its end.
enum class EndKind {
  kStopAtGoal,
  kStopElsewhere,
  kReached,  // under the condition "no_stop", where being near is enough
  kNoStop,   // out of steps or broken off
};

/// Where the body stood then.
struct GoalEnd {
  EndKind kind = EndKind::kNoStop;
  sim::BodyPose pose;
  std::size_t actions = 0;  // taken until then, stops too
};

/// One for each goal that the agent set out for, in order.
std::vector<GoalEnd> GoalEnds(const EpisodeTrajectory& trajectory);

}  // namespace bulletnav::bench
