// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/placing/room_space.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim::placing {

inline Eigen::Affine3f Moved(float x, float y, float z, float turn = 0.0f) {
  return Eigen::Translation3f(x, y, z) * RotationAbout<float>(Eigen::Vector3f::UnitY(), turn);
}

/// The box around a box that is moved.
inline Box Transformed(const Box& box, const Eigen::Affine3f& pose) {
  Box result;
  for (int i = 0; i < 8; ++i) {
    result.extend(pose * box.corner(static_cast<Box::CornerType>(i)));
  }
  return result;
}

}  // namespace bulletnav::sim::placing
