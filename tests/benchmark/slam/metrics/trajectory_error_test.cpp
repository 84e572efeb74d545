// SPDX-License-Identifier: MIT
#include "benchmark/slam/metrics/trajectory_error.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

using sim::PlanarPose;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<PlanarPose> RandomWalk(sim::Rng* rng, int size) {
  std::vector<PlanarPose> walk = {{1.0, -2.0, 0.7}};
  while (static_cast<int>(walk.size()) < size) {
    walk.push_back(Compose(walk.back(), {rng->Uniform(), 0.1 * rng->Normal(), rng->Normal()}));
  }
  return walk;
}

std::vector<PlanarPose> Moved(const PlanarPose& by, const std::vector<PlanarPose>& poses) {
  std::vector<PlanarPose> moved;
  for (const PlanarPose& pose : poses) moved.push_back(Compose(by, pose));
  return moved;
}

TEST(TrajectoryError, IsThatOfACountedExample) {
  const std::vector<PlanarPose> truth = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const std::vector<PlanarPose> estimate = {{5, 5, 0}, {6, 6, 0}, {7, 8, 0}, {8, 7, 0}};
  // Over each other at the start, they are 0, 1, 3 and 2 metres apart.
  const TrajectoryError error = MeasureTrajectory(truth, estimate, Alignment::kStart);
  EXPECT_DOUBLE_EQ(error.min, 0.0);
  EXPECT_DOUBLE_EQ(error.mean, 1.5);
  EXPECT_DOUBLE_EQ(error.max, 3.0);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt(14.0 / 4.0));
}

TEST(TrajectoryError, OfTheSameElsewhereIsNone) {
  sim::Rng rng(1, "walk");
  const auto truth = RandomWalk(&rng, 50);
  const auto estimate = Moved({3.0, -7.0, 2.5}, truth);
  for (const Alignment alignment : {Alignment::kStart, Alignment::kPlanar}) {
    EXPECT_LT(MeasureTrajectory(truth, estimate, alignment).max, 1e-12);
  }
}

/// No scale: twice the size stays wrong.
TEST(TrajectoryError, IsNotScaledAway) {
  const std::vector<PlanarPose> truth = {{0, 0, 0}, {2, 0, 0}};
  const std::vector<PlanarPose> estimate = {{0, 0, 0}, {4, 0, 0}};
  EXPECT_DOUBLE_EQ(MeasureTrajectory(truth, estimate, Alignment::kPlanar).rmse, 1.0);
  EXPECT_DOUBLE_EQ(MeasureTrajectory(truth, estimate, Alignment::kStart).max, 2.0);
}

double RmseWith(const PlanarPose& over, const std::vector<PlanarPose>& truth,
                const std::vector<PlanarPose>& estimate) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double x =
        over.x + std::cos(over.yaw) * estimate[i].x - std::sin(over.yaw) * estimate[i].y;
    const double y =
        over.y + std::sin(over.yaw) * estimate[i].x + std::cos(over.yaw) * estimate[i].y;
    sum += (x - truth[i].x) * (x - truth[i].x) + (y - truth[i].y) * (y - truth[i].y);
  }
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

/// Against trying all turns, each with its best move.
TEST(TrajectoryError, PlanarAlignmentIsTheBestOfAllTurns) {
  sim::Rng rng(2, "walk");
  for (int trial = 0; trial < 5; ++trial) {
    const auto truth = RandomWalk(&rng, 30);
    auto estimate = Moved({rng.Normal(), rng.Normal(), 3.0 * rng.Normal()}, truth);
    for (PlanarPose& pose : estimate) {
      pose.x += 0.3 * rng.Normal();
      pose.y += 0.3 * rng.Normal();
    }
    constexpr int kTurns = 20'000;
    double best = 1e9;
    for (int i = 0; i < kTurns; ++i) {
      PlanarPose over = {0.0, 0.0, 2.0 * sim::kPi * i / kTurns};
      double x = 0.0;
      double y = 0.0;
      for (std::size_t k = 0; k < truth.size(); ++k) {
        const PlanarPose turned = Compose(over, estimate[k]);
        x += (truth[k].x - turned.x) / static_cast<double>(truth.size());
        y += (truth[k].y - turned.y) / static_cast<double>(truth.size());
      }
      over.x = x;
      over.y = y;
      best = std::min(best, RmseWith(over, truth, estimate));
    }
    const double ours = MeasureTrajectory(truth, estimate, Alignment::kPlanar).rmse;
    EXPECT_LE(ours, best + 1e-12);
    EXPECT_NEAR(ours, best, 1e-5);
    EXPECT_NEAR(ours, RmseWith(AlignmentOf(truth, estimate, Alignment::kPlanar), truth, estimate),
                1e-12);
  }
}

TEST(TrajectoryError, TellsWhatIsWrong) {
  const std::vector<PlanarPose> one = {{0, 0, 0}};
  const std::vector<PlanarPose> bad = {{0, std::nan(""), 0}};
  const auto measure = [](const auto& truth, const auto& estimate) {
    return [&] {
      MeasureTrajectory(truth, estimate, Alignment::kStart);
    };
  };
  const std::vector<PlanarPose> none;
  EXPECT_THAT(measure(one, none), ThrowsMessage<sim::Error>(HasSubstr("0 poses cannot be held")));
  EXPECT_THAT(measure(none, none), ThrowsMessage<sim::Error>(HasSubstr("at least one")));
  EXPECT_THAT(measure(one, bad), ThrowsMessage<sim::Error>(HasSubstr("pose 1 of a trajectory")));
}

}  // namespace
}  // namespace bulletnav::bench
