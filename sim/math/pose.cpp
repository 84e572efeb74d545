// SPDX-License-Identifier: MIT
#include "sim/math/pose.h"

#include <cmath>

#include "sim/base/elementary.h"

namespace bulletnav::sim {

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

Eigen::Vector3d BodyPose::forward() const {
  return {-Sin(yaw), 0.0, -Cos(yaw)};
}

Eigen::Vector3d BodyPose::left() const {
  return {-Cos(yaw), 0.0, Sin(yaw)};
}

PlanarPose RelativePose(const BodyPose& X_WA, const BodyPose& X_WB) {
  const Eigen::Vector3d motion = X_WB.position - X_WA.position;
  return {motion.dot(X_WA.forward()), motion.dot(X_WA.left()), WrapAngle(X_WB.yaw - X_WA.yaw)};
}

PlanarPose Compose(const PlanarPose& X_AB, const PlanarPose& X_BC) {
  const double c = Cos(X_AB.yaw);
  const double s = Sin(X_AB.yaw);
  return {X_AB.x + c * X_BC.x - s * X_BC.y, X_AB.y + s * X_BC.x + c * X_BC.y,
          WrapAngle(X_AB.yaw + X_BC.yaw)};
}

PlanarPose Inverse(const PlanarPose& X_AB) {
  const double c = Cos(X_AB.yaw);
  const double s = Sin(X_AB.yaw);
  return {-c * X_AB.x - s * X_AB.y, s * X_AB.x - c * X_AB.y, WrapAngle(-X_AB.yaw)};
}

BodyPose Apply(const BodyPose& X_WA, const PlanarPose& X_AB) {
  return {X_WA.position + X_AB.x * X_WA.forward() + X_AB.y * X_WA.left(),
          WrapAngle(X_WA.yaw + X_AB.yaw)};
}

}  // namespace bulletnav::sim
