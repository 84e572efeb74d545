// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

#include "sim/base/elementary.h"

namespace bulletnav::sim {

/// The rotation by `angle` radians about an axis of length 1, counter-clockwise seen from its tip:
/// Rodrigues' formula, with the same bits on every processor.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> RotationAbout(const Eigen::Matrix<Scalar, 3, 1>& axis, Scalar angle) {
  const Scalar c = Cos(angle);
  const Eigen::Matrix<Scalar, 3, 1> sine = Sin(angle) * axis;
  Eigen::Matrix<Scalar, 3, 3> rotation = ((Scalar{1} - c) * axis) * axis.transpose();
  rotation.diagonal().array() += c;
  rotation(0, 1) -= sine.z();
  rotation(1, 0) += sine.z();
  rotation(0, 2) += sine.y();
  rotation(2, 0) -= sine.y();
  rotation(1, 2) -= sine.x();
  rotation(2, 1) += sine.x();
  return rotation;
}

}  // namespace bulletnav::sim
