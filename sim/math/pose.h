// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

namespace bulletnav::sim {

inline constexpr double kPi = 3.14159265358979323846;

constexpr double DegToRad(double deg) {
  return deg * (kPi / 180.0);
}
constexpr double RadToDeg(double rad) {
  return rad * (180.0 / kPi);
}

/// `angle` brought into (-pi, pi].
double WrapAngle(double angle);

/// Pose of an upright body B in the world W (y up, metres).
/// `position`: the point on the floor under the body's axis. `yaw`: radians about +y, 0 looks along
/// -z, positive turns left (counter-clockwise from above). Source: glTF and Habitat's frame.
struct BodyPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double yaw = 0.0;

  /// Unit vector the body looks along.
  Eigen::Vector3d forward() const;
  /// Unit vector to the body's left.
  Eigen::Vector3d left() const;
};

/// Pose in the plane, robotics style: x forward, y left (metres), yaw counter-clockwise (radians).
/// What agents use: relative to their start pose, or the motion of one step.
struct PlanarPose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
};

/// Pose of B seen from A, both in the world; heights are ignored. `yaw` is wrapped.
PlanarPose RelativePose(const BodyPose& X_WA, const BodyPose& X_WB);

/// X_AC = X_AB * X_BC. `yaw` is wrapped.
PlanarPose Compose(const PlanarPose& X_AB, const PlanarPose& X_BC);

/// X_BA = inverse of X_AB.
PlanarPose Inverse(const PlanarPose& X_AB);

/// World pose of B from the world pose of A and B seen from A; keeps A's height.
BodyPose Apply(const BodyPose& X_WA, const PlanarPose& X_AB);

}  // namespace bulletnav::sim
