// SPDX-License-Identifier: MIT
#include "benchmark/privileged/oracle_goal_estimator.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

/// A room 8 x 8 m with a wall across its middle, at z = -4, from x = 0 to 5, `height` high.
GroundTruth Room(float height) {
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.6f, 8);
  tests::AddBox({0, 0, -4.1f}, {5, height, -4.0f}, {9, 9, 9}, &mesh);
  GroundTruth truth;
  truth.world = sim::World::FromMesh(mesh, "room");
  truth.pose = {{2, 0, -3}, 0.0};
  return truth;
}

TEST(OracleGoalEstimator, GivesDistanceAndBearingFromTheBody) {
  GroundTruth truth = Room(2.6f);
  OracleGoalEstimator oracle(truth);
  truth.goal.position = {4, 0, -3};  // to the right of a body that looks along -z
  const auto right = oracle.Estimate({}, {});
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->distance, 2.0, 1e-9);
  EXPECT_NEAR(right->bearing, -sim::kPi / 2, 1e-9);
  truth.pose.yaw = sim::kPi;
  EXPECT_NEAR(oracle.Estimate({}, {})->bearing, sim::kPi / 2, 1e-9);
}

TEST(OracleGoalEstimator, DoesNotSeeThroughWallsNorBeyondThreeMetres) {
  GroundTruth truth = Room(2.6f);
  OracleGoalEstimator oracle(truth);
  truth.goal.position = {2, 0, -5};
  EXPECT_FALSE(oracle.Estimate({}, {}));
  truth.goal.position = {4.99, 0, -3};
  EXPECT_TRUE(oracle.Estimate({}, {}));
  truth.goal.position = {5.01, 0, -3};
  EXPECT_FALSE(oracle.Estimate({}, {}));
}

TEST(OracleGoalEstimator, SeesOverWhatIsLowerThanTheCamera) {
  GroundTruth truth = Room(1.0f);
  OracleGoalEstimator oracle(truth);
  truth.goal.position = {2, 0, -5};
  EXPECT_TRUE(oracle.Estimate({}, {}));
}

}  // namespace
}  // namespace bulletnav::bench
