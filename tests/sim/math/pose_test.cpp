// SPDX-License-Identifier: MIT
#include "sim/math/pose.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::sim {
namespace {

PlanarPose RandomPlanar(Rng* rng) {
  return {rng->Uniform(-5, 5), rng->Uniform(-5, 5), rng->Uniform(-kPi, kPi)};
}

void ExpectNear(const PlanarPose& a, const PlanarPose& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(WrapAngle(a.yaw - b.yaw), 0.0, 1e-12);
}

TEST(Pose, IdentityLooksAlongMinusZAndLeftIsMinusX) {
  const BodyPose pose;
  EXPECT_TRUE(pose.forward().isApprox(Eigen::Vector3d(0, 0, -1)));
  EXPECT_TRUE(pose.left().isApprox(Eigen::Vector3d(-1, 0, 0)));
}

TEST(Pose, PositiveYawTurnsLeft) {
  const BodyPose pose{Eigen::Vector3d::Zero(), kPi / 2};
  EXPECT_TRUE(pose.forward().isApprox(Eigen::Vector3d(-1, 0, 0)));
}

TEST(Pose, WrapAngleKeepsTheDirectionInHalfOpenTurn) {
  for (const double angle : {0.0, 3.0, -3.0, kPi, -kPi, 7.0, -7.0, 100.0, 1e6}) {
    const double wrapped = WrapAngle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-9);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-9);
  }
}

TEST(Pose, RelativePoseOfAStepAheadLeft) {
  const BodyPose a{{1, 0, 2}, 0.7};
  const BodyPose b{a.position + 0.5 * a.forward() + 0.2 * a.left(), 0.9};
  ExpectNear(RelativePose(a, b), {0.5, 0.2, 0.2});
}

TEST(Pose, ApplyUndoesRelativePose) {
  Rng rng(1, "pose");
  for (int i = 0; i < 100; ++i) {
    const BodyPose a{{rng.Uniform(-5, 5), 0.3, rng.Uniform(-5, 5)}, rng.Uniform(-kPi, kPi)};
    const BodyPose b{{rng.Uniform(-5, 5), 0.3, rng.Uniform(-5, 5)}, rng.Uniform(-kPi, kPi)};
    const BodyPose again = Apply(a, RelativePose(a, b));
    EXPECT_TRUE(again.position.isApprox(b.position, 1e-12));
    EXPECT_NEAR(WrapAngle(again.yaw - b.yaw), 0.0, 1e-12);
  }
}

TEST(Pose, ComposeIsAGroup) {
  Rng rng(2, "pose");
  for (int i = 0; i < 100; ++i) {
    const PlanarPose a = RandomPlanar(&rng);
    const PlanarPose b = RandomPlanar(&rng);
    const PlanarPose c = RandomPlanar(&rng);
    ExpectNear(Compose(a, Compose(b, c)), Compose(Compose(a, b), c));
    ExpectNear(Compose(a, Inverse(a)), {});
    ExpectNear(Compose(Inverse(a), a), {});
  }
}

TEST(Pose, ComposingStepsFollowsTheBody) {
  Rng rng(3, "pose");
  const BodyPose start{{1, 0, 1}, 0.4};
  BodyPose body = start;
  PlanarPose estimate;
  for (int i = 0; i < 50; ++i) {
    const PlanarPose motion = {rng.Uniform(0, 0.3), rng.Uniform(-0.1, 0.1), rng.Uniform(-1, 1)};
    body = Apply(body, motion);
    estimate = Compose(estimate, motion);
  }
  const PlanarPose truth = RelativePose(start, body);
  EXPECT_NEAR(estimate.x, truth.x, 1e-9);
  EXPECT_NEAR(estimate.y, truth.y, 1e-9);
}

}  // namespace
}  // namespace bulletnav::sim
