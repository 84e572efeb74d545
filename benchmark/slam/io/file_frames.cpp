// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/file_frames.h"

#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// From a camera's axes to those of its body, x ahead, y left, z up.
Eigen::Quaterniond BodyFromCamera() {
  return {0.5, -0.5, 0.5, -0.5};
}

}  // namespace

agent::SpatialPose CameraInFile(const sim::PlanarPose& X_FB, double camera_height) {
  const agent::SpatialPose mount = {{0.0, 0.0, camera_height}, BodyFromCamera()};
  return agent::Compose(agent::InSpace(X_FB), mount);
}

agent::SpatialPose CameraInFile(const sim::BodyPose& X_WB, double camera_height) {
  const Eigen::Vector3d& p = X_WB.position;
  return CameraInFile(sim::PlanarPose{-p.z(), -p.x(), X_WB.yaw}, p.y() + camera_height);
}

sim::PlanarPose PlanarFromFile(const agent::SpatialPose& X_FC) {
  const Eigen::Vector3d ahead = X_FC.rotation * Eigen::Vector3d::UnitZ();
  if (ahead.head<2>().norm() < 1e-6) {
    throw sim::Error("a camera that looks straight up or down has no yaw; leave the pose out");
  }
  return {X_FC.position.x(), X_FC.position.y(), std::atan2(ahead.y(), ahead.x())};
}

Eigen::Matrix3d LevelFromCamera(const agent::SpatialPose& X_FC) {
  const Eigen::Quaterniond upright = agent::InSpace(PlanarFromFile(X_FC)).rotation;
  return (upright.conjugate() * X_FC.rotation * BodyFromCamera().conjugate()).toRotationMatrix();
}

sim::BodyPose BodyFromFile(const agent::SpatialPose& X_FC, double camera_height) {
  const sim::PlanarPose flat = PlanarFromFile(X_FC);
  return {{-flat.y, X_FC.position.z() - camera_height, -flat.x}, flat.yaw};
}

}  // namespace bulletnav::bench
