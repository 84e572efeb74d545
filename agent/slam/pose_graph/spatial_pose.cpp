// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/spatial_pose.h"

namespace bulletnav::agent {

SpatialPose Compose(const SpatialPose& X_AB, const SpatialPose& X_BC) {
  return {X_AB.position + X_AB.rotation * X_BC.position,
          (X_AB.rotation * X_BC.rotation).normalized()};
}

SpatialPose Inverse(const SpatialPose& X_AB) {
  const Eigen::Quaterniond back = X_AB.rotation.conjugate();
  return {-(back * X_AB.position), back};
}

SpatialPose InSpace(const sim::PlanarPose& pose) {
  return {{pose.x, pose.y, 0.0}, RotationBy(pose.yaw * Eigen::Vector3d::UnitZ())};
}

Eigen::Vector3d RotationVector(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Quaterniond RotationBy(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace bulletnav::agent
