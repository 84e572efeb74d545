// SPDX-License-Identifier: MIT
#include "agent/perception/relative_pose.h"

#include <gtest/gtest.h>

#include "sim/math/pose.h"

namespace bulletnav::agent {
namespace {

TEST(RelativePose, DirectionsAndBearingsAreInverse) {
  for (int i = 0; i < kDirections; ++i) {
    for (const double off : {-0.26, -0.1, 0.0, 0.1, 0.26}) {
      EXPECT_EQ(DirectionOf(BearingOf(i) + off), i);
    }
  }
  EXPECT_DOUBLE_EQ(BearingOf(3), sim::kPi / 2);
  EXPECT_NEAR(BearingOf(9), -sim::kPi / 2, 1e-12);
}

TEST(RelativePose, TakesTheLikeliestDirection) {
  PairPrediction p;
  p.distance = 1.5f;
  p.direction[4] = 1.0f;
  EXPECT_NEAR(RelativePoseOf(p).bearing, BearingOf(4), 1e-6);
  EXPECT_NEAR(RelativePoseOf(p).distance, 1.5, 1e-6);
}

TEST(RelativePose, MeetsInTheMiddleOfTwoAlsoAcrossTheSeam) {
  PairPrediction p;
  p.direction[11] = 0.5f;
  p.direction[0] = 0.5f;
  EXPECT_NEAR(RelativePoseOf(p).bearing, -sim::kPi / 12, 1e-6);
  p.direction[11] = 0.25f;
  p.direction[0] = 0.75f;
  EXPECT_NEAR(RelativePoseOf(p).bearing, -sim::kPi / 24, 1e-6);
}

TEST(RelativePose, SaysSomethingEvenIfNoDirectionIsLikely) {
  EXPECT_EQ(RelativePoseOf({}).bearing, 0.0);
}

}  // namespace
}  // namespace bulletnav::agent
