// SPDX-License-Identifier: MIT
#include "benchmark/play/metrics.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr SuccessRule kStop;
constexpr SuccessRule kNoStop = {1.0, true};

/// An episode of 4 m that the agent walked in 5 m and stopped `distance` before the goal.
GoalRecord StoppedAt(double distance) {
  return {4.0, distance, distance, 5.0, true, 40, 2};
}

TEST(Measure, StopJustInsideAMetreSucceeds) {
  const GoalMetrics m = MeasureGoal(StoppedAt(0.999), kStop);
  EXPECT_TRUE(m.success());
  EXPECT_EQ(m.Value("success_euclidean"), 1.0);
  EXPECT_DOUBLE_EQ(m.Value("spl"), 4.0 / 5.0);
  EXPECT_DOUBLE_EQ(m.Value("soft_spl"), (1.0 - 0.999 / 4.0) * 4.0 / 5.0);
  EXPECT_EQ(m.Value("distance_to_goal"), 0.999);
  EXPECT_EQ(m.Whole("steps"), 40);
  EXPECT_EQ(m.Whole("collisions"), 2);
}

TEST(Measure, StopAtAMetreOrBeyondFails) {
  for (const double distance : {1.0, 1.001}) {
    const GoalMetrics m = MeasureGoal(StoppedAt(distance), kStop);
    EXPECT_FALSE(m.success());
    EXPECT_EQ(m.Value("success_euclidean"), 0.0);
    EXPECT_EQ(m.Value("spl"), 0.0);
    EXPECT_DOUBLE_EQ(m.Value("soft_spl"), (1.0 - distance / 4.0) * 4.0 / 5.0);
  }
}

TEST(Measure, StopBehindAWallCountsByTheStraightLineOnly) {
  GoalRecord record = StoppedAt(3.0);
  record.euclidean_distance = 0.4;
  const GoalMetrics m = MeasureGoal(record, kStop);
  EXPECT_FALSE(m.success());
  EXPECT_EQ(m.Value("success_euclidean"), 1.0);
  EXPECT_EQ(m.Value("spl"), 0.0);
}

TEST(Measure, WithoutAStopNothingSucceeds) {
  GoalRecord record = StoppedAt(0.0);
  record.stopped = false;
  const GoalMetrics m = MeasureGoal(record, kStop);
  EXPECT_FALSE(m.success());
  EXPECT_EQ(m.Value("success_euclidean"), 0.0);
  EXPECT_EQ(m.Value("spl"), 0.0);
  EXPECT_DOUBLE_EQ(m.Value("soft_spl"), 0.8);
}

TEST(Measure, NoStopConditionAsksForNoStop) {
  GoalRecord record = StoppedAt(0.9);
  record.stopped = false;
  EXPECT_TRUE(MeasureGoal(record, kNoStop).success());
  EXPECT_DOUBLE_EQ(MeasureGoal(record, kNoStop).Value("spl"), 0.8);
  record.distance_to_goal = 1.5;
  EXPECT_FALSE(MeasureGoal(record, kNoStop).success());
}

TEST(Measure, WayNoLongerThanTheShortestIsWorthOne) {
  // Shorter than the geodesic: the metre that success leaves over.
  GoalRecord record = StoppedAt(0.5);
  record.path_length = 3.5;
  EXPECT_EQ(MeasureGoal(record, kStop).Value("spl"), 1.0);
  record.path_length = 4.0;
  EXPECT_EQ(MeasureGoal(record, kStop).Value("spl"), 1.0);
}

TEST(Measure, StartWithinAMetre) {
  // Stopping at once is right and costs nothing; walking about first costs its length.
  const GoalRecord at_once = {0.6, 0.6, 0.6, 0.0, true, 1, 0};
  EXPECT_TRUE(MeasureGoal(at_once, kStop).success());
  EXPECT_EQ(MeasureGoal(at_once, kStop).Value("spl"), 1.0);
  EXPECT_EQ(MeasureGoal(at_once, kStop).Value("soft_spl"), 0.0);
  const GoalRecord about = {0.6, 0.6, 0.6, 2.4, true, 12, 0};
  EXPECT_DOUBLE_EQ(MeasureGoal(about, kStop).Value("spl"), 0.25);
}

TEST(Measure, StartOnTheGoal) {
  const GoalRecord still = {0.0, 0.0, 0.0, 0.0, true, 1, 0};
  EXPECT_EQ(MeasureGoal(still, kStop).Value("spl"), 1.0);
  EXPECT_EQ(MeasureGoal(still, kStop).Value("soft_spl"), 1.0);
  const GoalRecord moved = {0.0, 0.25, 0.25, 0.25, true, 2, 0};
  EXPECT_TRUE(MeasureGoal(moved, kStop).success());
  EXPECT_EQ(MeasureGoal(moved, kStop).Value("spl"), 0.0);
  EXPECT_EQ(MeasureGoal(moved, kStop).Value("soft_spl"), 0.0);
}

TEST(Measure, EndOffTheGoalsIslandIsInfinitelyFar) {
  GoalRecord record = StoppedAt(kInfinity);
  record.euclidean_distance = 0.3;
  const GoalMetrics m = MeasureGoal(record, kStop);
  EXPECT_FALSE(m.success());
  EXPECT_EQ(m.Value("soft_spl"), 0.0);
  EXPECT_EQ(m.Value("distance_to_goal"), kInfinity);
}

TEST(Measure, OfAnAgentThatWasTakenOffIsNoSuccess) {
  GoalRecord record = StoppedAt(0.5);
  record.failed = true;
  for (const SuccessRule& rule : {kStop, kNoStop}) {
    const GoalMetrics m = MeasureGoal(record, rule);
    EXPECT_FALSE(m.success());
    EXPECT_EQ(m.Value("success_euclidean"), 0.0);
    EXPECT_EQ(m.Value("spl"), 0.0);
    EXPECT_DOUBLE_EQ(m.Value("soft_spl"), (1.0 - 0.5 / 4.0) * 4.0 / 5.0);
  }
}

TEST(Measures, AreTheFilesOfTheirFolder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(BULLETNAV_MEASURES)) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path().stem().string());
  }
  std::vector<std::string> names;
  for (const Measure& measure : AllMeasures()) names.emplace_back(measure.name);
  EXPECT_THAT(names, testing::UnorderedElementsAreArray(files));
}

TEST(Measures, UnknownNamesAreRefusedWithTheKnownOnes) {
  try {
    FindMeasure("sucess");
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("'sucess'"),
                                         testing::HasSubstr("success, success_euclidean, spl")));
  }
}

TEST(EpisodeValue, GoesOverTheGoalsAsTheMeasureSays) {
  const std::vector<GoalMetrics> goals = {
      {{"success", 1.0}, {"steps", 10.0}, {"distance_to_goal", 0.5}},
      {{"success", 0.0},
       {"steps", 20.0},
       {"distance_to_goal", kInfinity},
       {"euclidean_distance", 4.5}}};
  EXPECT_EQ(EpisodeValue(FindMeasure("success"), goals), 0.5);
  EXPECT_EQ(EpisodeValue(FindMeasure("steps"), goals), 30.0);
  EXPECT_EQ(EpisodeValue(FindMeasure("distance_to_goal"), goals), 2.5) << "the straight line";
  EXPECT_EQ(EpisodeValue(FindMeasure("collisions"), goals), std::nullopt) << "not measured";
  Measure steps = FindMeasure("steps");
  steps.over_goals = OverGoals::kMeanOfReached;
  EXPECT_EQ(EpisodeValue(steps, goals), 10.0);
  EXPECT_EQ(EpisodeValue(steps, {&goals[1], 1}), std::nullopt);
}

TEST(GoalMetrics, WhatIsMissingIsNamed) {
  const GoalMetrics m = {{"success", 1.0}};
  EXPECT_EQ(m.Find("spl"), std::nullopt);
  try {
    m.Value("spl");
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("no 'spl'"));
  }
}

/// A room of 6 x 6 m cut by a wall of 0.1 m along z = -3, with a gap of a metre at x > 5.
class GoalWatchTest : public testing::Test {
 protected:
  static sim::SceneMesh Mesh() {
    sim::SceneMesh mesh = tests::BoxRoom(6, 2.5f, 6);
    tests::AddBox({0, 0, -3.05f}, {5, 2.5f, -2.95f}, sim::kWhite, &mesh);
    return mesh;
  }
  const sim::Navmesh navmesh_{Mesh(), {}};
  const sim::NavmeshQuery query_{navmesh_};
};

TEST_F(GoalWatchTest, AddsUpStepsWayAndCollisions) {
  GoalWatch watch(query_, {1, 0, -1}, {1, 0, -2.5}, kStop);
  watch.Step({1.25, 0, -1}, false);
  watch.Step({1.25, 0, -1}, true);
  watch.Step({1.25, 0, -1.5}, true);
  const GoalMetrics m = watch.Finish(true);
  EXPECT_EQ(m.Whole("steps"), 3);
  EXPECT_EQ(m.Whole("collisions"), 2);
  EXPECT_DOUBLE_EQ(m.Value("path_length"), 0.75);
  EXPECT_NEAR(m.Value("start_distance"), 1.5, 0.02);
  EXPECT_NEAR(m.Value("distance_to_goal"), std::hypot(0.25, 1.0), 0.02);
  EXPECT_FALSE(m.success());
}

TEST_F(GoalWatchTest, SeesThroughNoWall) {
  // 0.6 m from the goal through the wall, about 8 m around it.
  GoalWatch watch(query_, {1, 0, -1}, {1, 0, -3.3}, kStop);
  watch.Step({1, 0, -2.7}, false);
  EXPECT_FALSE(watch.Reached());
  const GoalMetrics m = watch.Finish(true);
  EXPECT_FALSE(m.success());
  EXPECT_EQ(m.Value("success_euclidean"), 1.0);
  EXPECT_NEAR(m.Value("euclidean_distance"), 0.6, 1e-9);
  EXPECT_GT(m.Value("distance_to_goal"), 8.0);
}

TEST_F(GoalWatchTest, NoStopIsOverAsSoonAsTheGoalIsNear) {
  GoalWatch watch(query_, {1, 0, -1}, {4, 0, -1}, kNoStop);
  double x = 1.0;
  while (!watch.Reached()) {
    x += 0.25;
    ASSERT_LT(x, 4.0);
    watch.Step({x, 0, -1}, false);
  }
  EXPECT_GT(x, 2.99);
  EXPECT_LT(x, 3.30);
  EXPECT_TRUE(watch.Finish(false).success());
  EXPECT_EQ(watch.Finish(false).Value("spl"), 1.0);
}

TEST_F(GoalWatchTest, StartNearTheGoalIsReachedWithoutAStep) {
  const GoalWatch watch(query_, {1, 0, -1}, {1.5, 0, -1}, kNoStop);
  EXPECT_TRUE(watch.Reached());
  const GoalMetrics m = watch.Finish(false);
  EXPECT_TRUE(m.success());
  EXPECT_EQ(m.Value("spl"), 1.0);
  EXPECT_EQ(m.Whole("steps"), 0);
}

TEST_F(GoalWatchTest, FailureKeepsWhatWasWalked) {
  for (const SuccessRule& rule : {kStop, kNoStop}) {
    GoalWatch watch(query_, {1, 0, -1}, {1.5, 0, -1}, rule);
    watch.Step({1.25, 0, -1}, true);
    const GoalMetrics m = watch.Fail();
    EXPECT_FALSE(m.success());
    EXPECT_EQ(m.Value("spl"), 0.0);
    EXPECT_EQ(m.Whole("steps"), 1);
    EXPECT_EQ(m.Whole("collisions"), 1);
    EXPECT_NEAR(m.Value("path_length"), 0.25, 1e-9);
  }
}

TEST_F(GoalWatchTest, UntriedGoalsAreAsFarAsTheyWere) {
  const GoalMetrics near = UntriedGoal(query_, {1, 0, -1}, {1.5, 0, -1}, 7.0);
  EXPECT_FALSE(near.success()) << "though it is near";
  EXPECT_NEAR(near.Value("start_distance"), 0.5, 0.02);
  EXPECT_EQ(near.Whole("steps"), 0);
  const GoalMetrics cut_off = UntriedGoal(query_, {1, 0, -1}, {100, 0, -1}, 7.0);
  EXPECT_EQ(cut_off.Value("start_distance"), 7.0);
  EXPECT_EQ(cut_off.Value("distance_to_goal"), kInfinity);
}

TEST_F(GoalWatchTest, RefusesGoalsThatCannotBeReached) {
  EXPECT_THROW(GoalWatch(query_, {1, 0, -1}, {100, 0, -1}, kStop), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
