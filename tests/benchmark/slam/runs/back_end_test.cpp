// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/back_end.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

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
  const Poses odometry = Around(0.01);
  const BackEndOutcome outcome = RunBackEnd(odometry, {}, {});
  EXPECT_EQ(outcome.trouble, "");
  EXPECT_TRUE(outcome.accepted.empty());
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    EXPECT_NEAR(outcome.poses[i].x, odometry[i].x, 1e-9);
    EXPECT_NEAR(outcome.poses[i].yaw, odometry[i].yaw, 1e-9);
  }
}

TEST(BackEnd, LoopsBendDriftBack) {
  const Poses odometry = Around(0.01);
  const BackEndOutcome outcome = RunBackEnd(odometry, LoopsOfTheSecondLap(), {});
  EXPECT_EQ(outcome.accepted.size(), 12u);
  EXPECT_LT(LargestError(outcome.poses), 0.5 * LargestError(odometry));
}

/// Wrong loops that agree with nothing go, the right ones stay.
TEST(BackEnd, LoopsThatContradictTheOthersAreLeftOut) {
  std::vector<MeasuredLoop> loops = LoopsOfTheSecondLap();
  loops.insert(loops.begin(), {50, 2, {0.3, 0.1, 1.0}});
  loops.push_back({70, 20, {0.0, 0.2, -2.0}});
  const BackEndOutcome outcome = RunBackEnd(Around(0.01), loops, {});
  EXPECT_EQ(outcome.accepted.size(), 12u);
  EXPECT_FALSE(std::binary_search(outcome.accepted.begin(), outcome.accepted.end(), 0));
  EXPECT_FALSE(std::binary_search(outcome.accepted.begin(), outcome.accepted.end(), 13));
}

TEST(BackEnd, TroubleIsToldAndOdometryKept) {
  const std::vector<MeasuredLoop> loops = {{99, 0, {}}};
  const BackEndOutcome outcome = RunBackEnd(Poses(3), loops, {});
  EXPECT_NE(outcome.trouble, "");
  EXPECT_EQ(outcome.poses.size(), 3u);
}

}  // namespace
}  // namespace bulletnav::bench
