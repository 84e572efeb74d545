// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/labels.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::DoubleNear;
using testing::FloatNear;

TEST(LabelsTest, BearingsFallIntoTheDirectionWhoseCentreIsNearest) {
  for (int i = 0; i < agent::kDirections; ++i) {
    for (const double off_deg : {-14.9, 0.0, 14.9}) {
      for (const int turns : {-1, 0, 2}) {
        const double bearing = BearingOf(i) + sim::DegToRad(off_deg) + turns * 2.0 * sim::kPi;
        EXPECT_EQ(DirectionOf(bearing), i) << off_deg << " and " << turns << " turns";
      }
    }
  }
  EXPECT_EQ(DirectionOf(sim::kPi), 6);
  EXPECT_EQ(DirectionOf(-sim::kPi), 6);
  EXPECT_EQ(DirectionOf(sim::kPi / 2), 3);
}

TEST(LabelsTest, DirectionsCountCounterClockwiseFromStraightAhead) {
  const sim::BodyPose pose = {Eigen::Vector3d(1, 0.5, 2), 0.0};
  EXPECT_TRUE(PointAlong(pose, 0, 3.0).position.isApprox(Eigen::Vector3d(1, 0.5, -1)));
  EXPECT_TRUE(PointAlong(pose, 3, 3.0).position.isApprox(Eigen::Vector3d(-2, 0.5, 2)));
  EXPECT_TRUE(PointAlong(pose, 6, 3.0).position.isApprox(Eigen::Vector3d(1, 0.5, 5)));
}

TEST(LabelsTest, PosesBecomeDirectionAndDistance) {
  const PairLabel left = LabelPose({0.0, 1.5, 0.3});
  EXPECT_EQ(left.direction, 3);
  EXPECT_EQ(left.distance, 1500);
  EXPECT_THAT(left.near_score(), FloatNear(0.5f, 1e-6f));
  EXPECT_EQ(LabelPose({-2.0, -0.01, 0.0}).direction, 6);
  EXPECT_EQ(LabelPose({-4.0, 0.0, 0.0}).near_score(), 0.0f);
  EXPECT_EQ(LabelPose({0.0, 0.0, 1.0}).near_score(), 1.0f);
  EXPECT_EQ(LabelPose({90.0, 0.0, 0.0}).distance, 65535);
}

TEST(LabelsTest, FarScoresFallOverTwentyMetresToNothing) {
  PairLabel label;
  for (const double distance : {0.0, 0.1, 3.7, 12.0, 19.99, 20.0, 35.0}) {
    label.score[4] = QuantisedFarScore(distance);
    const double exact = std::max(1.0 - distance / 20.0, 0.0);
    EXPECT_THAT(double{label.far_score(4)}, DoubleNear(exact, 0.5 / 255.0 + 1e-6)) << distance;
  }
  EXPECT_EQ(QuantisedFarScore(std::numeric_limits<double>::infinity()), 0);
}

}  // namespace
}  // namespace bulletnav::bench
