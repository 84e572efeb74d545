// SPDX-License-Identifier: MIT
#include "sim/import/door_joint.h"

#include <algorithm>
#include <cmath>

#include "sim/base/lower_case.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

constexpr float kUpright = 0.98f;  // least part of a door's axis along the upright

}  // namespace

std::optional<DoorLeaf> LeafOn(const TurningJoint& joint, const Eigen::Vector3f& up) {
  if (!(std::abs(joint.axis.dot(up)) > kUpright) || joint.lower == joint.upper) return std::nullopt;
  DoorLeaf door;
  door.hinge = joint.hinge;
  door.axis = joint.axis;
  if (joint.angle_at_zero) {
    const double zero = *joint.angle_at_zero;
    door.angle = static_cast<float>(zero + joint.position);
    door.shut_angle = static_cast<float>(zero + joint.lower);
    door.open_angle = static_cast<float>(zero + joint.upper);
    return door;
  }
  const double low = std::max(joint.lower, -0.5 * kPi);
  const double high = std::min(joint.upper, 0.5 * kPi);
  const bool opens_backwards = -low > high;
  if (opens_backwards) door.axis = -door.axis;
  door.angle = static_cast<float>(opens_backwards ? -joint.position : joint.position);
  door.shut_angle = static_cast<float>(opens_backwards ? -std::min(0.0, high) : std::max(0.0, low));
  door.open_angle = static_cast<float>(opens_backwards ? -low : high);
  return door;
}

bool NamesDoor(const std::string& text) {
  return LowerCase(text).find("door") != std::string::npos;
}

}  // namespace bulletnav::sim
