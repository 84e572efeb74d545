// SPDX-License-Identifier: MIT
#include "benchmark/report/goal_ends.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kStep = 0.25;

MATCHER_P2(EndsAfter, steps, kind, "") {
  return arg.kind == kind && arg.pose.position.x() == kStep * steps;
}

/// Steps in letters, F forward and S stop: each takes the body further, stops too.
EpisodeTrajectory Trajectory(const std::string& condition, const std::string& actions,
                             const std::vector<GoalMetrics>& goals) {
  EpisodeTrajectory trajectory;
  trajectory.result.key.condition = condition;
  trajectory.result.goals = goals;
  for (const char letter : actions) {
    TrajectoryStep step;
    step.action = letter == 'S' ? sim::Action::kStop : sim::Action::kMoveForward;
    trajectory.steps.push_back(step);
    const auto taken = static_cast<double>(trajectory.steps.size());
    trajectory.steps.back().pose.position.x() = kStep * taken;
  }
  return trajectory;
}

GoalMetrics Goal(bool success, int steps) {
  GoalMetrics metrics;
  metrics["success"] = success;
  metrics["steps"] = steps;
  return metrics;
}

TEST(GoalEnds, StopsAreGoodOnlyAtGoalsThatWereReached) {
  EXPECT_THAT(GoalEnds(Trajectory("noise", "FFFS", {Goal(true, 3)})),
              ElementsAre(EndsAfter(4, EndKind::kStopAtGoal)));
  EXPECT_THAT(GoalEnds(Trajectory("no_noise", "FFFS", {Goal(false, 3)})),
              ElementsAre(EndsAfter(4, EndKind::kStopElsewhere)));
}

TEST(GoalEnds, EachOfSeveralGoalsHasItsOwn) {
  const auto ends =
      GoalEnds(Trajectory("noise", "FSFFFSS", {Goal(true, 1), Goal(false, 3), Goal(true, 0)}));
  EXPECT_THAT(ends,
              ElementsAre(EndsAfter(2, EndKind::kStopAtGoal), EndsAfter(6, EndKind::kStopElsewhere),
                          EndsAfter(7, EndKind::kStopAtGoal)));
}

TEST(StepNumbers, AStopThatEndsAGoalIsNoStep) {
  EXPECT_THAT(StepNumbers(Trajectory("noise", "FSFFS", {Goal(true, 1), Goal(false, 2)})),
              ElementsAre(0, 1, 1, 2, 3, 3));
  EXPECT_THAT(StepNumbers(Trajectory("no_stop", "FSF", {Goal(true, 3)})), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(StepNumbers(Trajectory("noise", "", {Goal(false, 0)})), ElementsAre(0));
}

TEST(GoalEnds, StepsRunOut) {
  EXPECT_THAT(GoalEnds(Trajectory("noise", "FFFS", {Goal(false, 2), Goal(true, 1)})),
              ElementsAre(EndsAfter(2, EndKind::kNoStop), EndsAfter(4, EndKind::kStopAtGoal)));
}

TEST(GoalEnds, WithoutStopTheyAreWhereTheBodyWasNear) {
  EXPECT_THAT(
      GoalEnds(Trajectory("no_stop", "FSFFF", {Goal(true, 3), Goal(true, 0), Goal(false, 2)})),
      ElementsAre(EndsAfter(3, EndKind::kReached), EndsAfter(3, EndKind::kReached),
                  EndsAfter(5, EndKind::kNoStop)));
  EXPECT_THAT(GoalEnds(Trajectory("no_stop", "", {Goal(true, 0)})),
              ElementsAre(EndsAfter(0, EndKind::kReached)));
}

TEST(GoalEnds, GoalsNeverTriedHaveNone) {
  EXPECT_THAT(GoalEnds(Trajectory("noise", "FF", {Goal(false, 2), Goal(false, 0)})),
              ElementsAre(EndsAfter(2, EndKind::kNoStop)));
  EXPECT_THAT(GoalEnds(Trajectory("noise", "", {Goal(false, 0)})), IsEmpty());
}

TEST(GoalEnds, FewerStepsThanTheResultCountsAreNotOverrun) {
  EXPECT_THAT(GoalEnds(Trajectory("noise", "FF", {Goal(false, 9)})),
              ElementsAre(EndsAfter(2, EndKind::kNoStop)));
}

}  // namespace
}  // namespace bulletnav::bench
