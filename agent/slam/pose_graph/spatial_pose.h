// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Pose X_AB of B in space, seen from A: where B is (metres), and what turns B's axes into A's (of
/// length one).
struct SpatialPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// X_AC = X_AB * X_BC.
SpatialPose Compose(const SpatialPose& X_AB, const SpatialPose& X_BC);

/// X_BA = inverse of X_AB.
SpatialPose Inverse(const SpatialPose& X_AB);

/// A pose of the plane as one in space: at height 0, turned about z.
SpatialPose InSpace(const sim::PlanarPose& pose);

/// Axis times angle, at most pi long; and back.
Eigen::Vector3d RotationVector(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond RotationBy(const Eigen::Vector3d& vector);

}  // namespace bulletnav::agent
