// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "sim/scene/doors.h"

namespace bulletnav::sim {

/// What exports write into a door's joint: how far the leaf stands open, radians, where the joint
/// is at 0. With it, the joint's limits are where the door is shut and open.
inline constexpr const char* kAngleAtZero = "bulletnav:angle";

/// A joint that something turns on, in a scene's axes.
struct TurningJoint {
  Eigen::Vector3f hinge = Eigen::Vector3f::Zero();
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();  // unit
  double lower = 0.0;                               // radians, may be infinite
  double upper = 0.0;
  double position = 0.0;                // where it stands
  std::optional<double> angle_at_zero;  // see kAngleAtZero
};

/// The door on a joint, without its object, absent where the joint is not upright or
/// cannot turn. Shut is the
/// position nearest to 0, open the farther limit, a quarter turn at most; where `angle_at_zero` is
/// known, the lower limit and the upper one.
std::optional<DoorLeaf> LeafOn(const TurningJoint& joint, const Eigen::Vector3f& up);

/// Whether a text has the word door in it, in any letter case.
bool NamesDoor(const std::string& text);

}  // namespace bulletnav::sim
