// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/back_end.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using ::testing::ElementsAre;
using Poses = std::vector<sim::PlanarPose>;

/// Twice around a square of 4 m, a step of half a metre or a turn; with a small turn too much in
/// every step of odometry.
Poses Around(double turned_too_much) {
  Poses poses = {{}};
  for (int lap = 0; lap < 2; ++lap) {
    for (int side = 0; side < 4; ++side) {
      for (int step = 0; step < 8; ++step) {
        poses.push_back(sim::Compose(poses.back(), {0.5, 0.0, turned_too_much}));
      }
      poses.push_back(sim::Compose(poses.back(), {0.0, 0.0, sim::kPi / 2 + turned_too_much}));
    }
  }
  return poses;
}

constexpr int kLap = 36;

std::vector<MeasuredLoop> LoopsOfTheSecondLap() {
  const Poses truth = Around(0.0);
  std::vector<MeasuredLoop> loops;
  for (int later = kLap; later < 2 * kLap; later += 3) {
    loops.push_back({later, later - kLap, {}});
  }
  return loops;
}

double LargestError(const Poses& poses) {
  const Poses truth = Around(0.0);
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    largest = std::max(largest, std::hypot(poses[i].x - truth[i].x, poses[i].y - truth[i].y));
  }
  return largest;
}

TEST(BackEnd, WithoutLoopsOdometryStays) {
  const Poses odometry = Around(0.005);
  const BackEndOutcome outcome = RunBackEnd(odometry, {}, {});
  EXPECT_EQ(outcome.trouble, "");
  EXPECT_TRUE(outcome.accepted.empty());
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    EXPECT_NEAR(outcome.poses[i].x, odometry[i].x, 1e-9);
    EXPECT_NEAR(outcome.poses[i].yaw, odometry[i].yaw, 1e-9);
  }
}

TEST(BackEnd, LoopsBendDriftBack) {
  const Poses odometry = Around(0.005);
  const BackEndOutcome outcome = RunBackEnd(odometry, LoopsOfTheSecondLap(), {});
  EXPECT_EQ(outcome.accepted.size(), 12u);
  EXPECT_LT(LargestError(outcome.poses), 0.5 * LargestError(odometry));
}

/// Wrong loops that agree with nothing go, the right ones stay.
TEST(BackEnd, LoopsThatContradictTheOthersAreLeftOut) {
  std::vector<MeasuredLoop> loops = LoopsOfTheSecondLap();
  loops.insert(loops.begin(), {50, 2, {0.3, 0.1, 1.0}});
  loops.push_back({70, 20, {0.0, 0.2, -2.0}});
  const BackEndOutcome outcome = RunBackEnd(Around(0.005), loops, {});
  EXPECT_EQ(outcome.accepted.size(), 12u);
  EXPECT_FALSE(std::binary_search(outcome.accepted.begin(), outcome.accepted.end(), 0));
  EXPECT_FALSE(std::binary_search(outcome.accepted.begin(), outcome.accepted.end(), 13));
}

/// A loop that says the body stands 3 m from where it did after it has hardly moved.
TEST(BackEnd, LoopsThatOdometryRulesOutAreLeftOut) {
  const std::vector<MeasuredLoop> loops = {{10, 0, {-3.0, 3.0, 0.0}}, {40, 4, {}}, {64, 28, {}}};
  const Poses odometry = Around(0.001);
  EXPECT_THAT(RunBackEnd(odometry, loops, {}).accepted, ElementsAre(1, 2));
  BackEndSpec any;
  any.odometry_confidence = 0.0;
  any.consistent = false;
  any.most_error = 0.0;
  EXPECT_THAT(RunBackEnd(odometry, loops, any).accepted, ElementsAre(0, 1, 2));
}

/// One loop, or many of one place, that odometry is too unsure to back may be wrong: the trajectory
/// stays that of odometry.
TEST(BackEnd, ALoneRunDoesNotBendTheGraph) {
  const Poses odometry = Around(0.02);
  BackEndSpec unsure;
  unsure.step_deg = 3.0;
  unsure.step_m = 0.1;
  std::vector<MeasuredLoop> loops = {{38, 2, {}}};
  const auto expect_odometry = [&] {
    const BackEndOutcome outcome = RunBackEnd(odometry, loops, unsure);
    EXPECT_TRUE(outcome.accepted.empty());
    EXPECT_NEAR(LargestError(outcome.poses), LargestError(odometry), 1e-9);
  };
  expect_odometry();
  for (int i = 39; i < 44; ++i) loops.push_back({i, i - kLap, {}});
  expect_odometry();
  BackEndSpec lone = unsure;
  lone.runs = 1;
  EXPECT_EQ(RunBackEnd(odometry, loops, lone).accepted.size(), loops.size());
  // Another run that agrees supports them.
  loops.push_back({62, 62 - kLap, {}});
  EXPECT_EQ(RunBackEnd(odometry, loops, unsure).accepted.size(), loops.size());
}

/// In a short drive there may be one place alone that is seen twice. Odometry is sure yet, and says
/// the same.
TEST(BackEnd, ALoneRunThatOdometryBacksIsTaken) {
  const Poses odometry = Around(0.002);
  std::vector<MeasuredLoop> loops;
  for (int i = 40; i < 46; ++i) loops.push_back({i, i - kLap, {}});
  const BackEndOutcome outcome = RunBackEnd(odometry, loops, {});
  EXPECT_EQ(outcome.accepted.size(), loops.size());
  EXPECT_LT(LargestError(outcome.poses), LargestError(odometry));
  // Of one loop odometry is surer before it backs it than of many that agree.
  BackEndSpec unsure;
  unsure.step_deg = 1.0;
  unsure.step_m = 0.03;
  const Poses worse = Around(0.01);
  EXPECT_TRUE(RunBackEnd(worse, std::span(loops).first(1), unsure).accepted.empty());
  EXPECT_EQ(RunBackEnd(worse, loops, unsure).accepted.size(), loops.size());
  BackEndSpec never;
  never.lone_chance = 0.0;
  EXPECT_TRUE(RunBackEnd(odometry, loops, never).accepted.empty());
}

/// A loop that agrees with each of the others by itself, but not with what they all say together.
TEST(BackEnd, LoopsThatTheGraphStrainsAreLeftOut) {
  std::vector<MeasuredLoop> loops = LoopsOfTheSecondLap();
  loops.push_back({64, 28, {0.45, 0.0, 0.0}});
  BackEndSpec spec;
  spec.consistent = false;
  spec.odometry_confidence = 0.0;
  const BackEndOutcome outcome = RunBackEnd(Around(0.005), loops, spec);
  EXPECT_EQ(outcome.accepted.size(), 12u);
  EXPECT_FALSE(std::binary_search(outcome.accepted.begin(), outcome.accepted.end(), 12));
  spec.most_error = 0.0;
  EXPECT_EQ(RunBackEnd(Around(0.005), loops, spec).accepted.size(), 13u);
}

TEST(BackEnd, TroubleIsToldAndOdometryKept) {
  const std::vector<MeasuredLoop> loops = {{99, 0, {}}};
  const BackEndOutcome outcome = RunBackEnd(Poses(3), loops, {});
  EXPECT_NE(outcome.trouble, "");
  EXPECT_EQ(outcome.poses.size(), 3u);
}

}  // namespace
}  // namespace bulletnav::bench
