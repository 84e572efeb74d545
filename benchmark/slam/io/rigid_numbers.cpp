// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/rigid_numbers.h"

#include <cmath>

#include <fmt/core.h>

namespace bulletnav::bench {

agent::SpatialPose QuaternionPose(const TextLine& line, std::size_t first) {
  constexpr double kRounding = 0.01;
  const std::vector<double> n = line.Numbers(first, 7);
  const Eigen::Quaterniond rotation(n[6], n[3], n[4], n[5]);
  if (std::abs(rotation.norm() - 1.0) > kRounding) {
    line.Fail("the quaternion 'qx qy qz qw' is not of length 1; normalise it");
  }
  return {{n[0], n[1], n[2]}, rotation.normalized()};
}

void ExpectNear(const TextLine& line, const Eigen::Vector3d& position) {
  constexpr double kFarthest = 1e7;
  if (position.cwiseAbs().maxCoeff() <= kFarthest) return;
  line.Fail("the place is more than 1e7 m away; mend the line");
}

std::string ToText(const agent::SpatialPose& pose) {
  Eigen::Quaterniond q = pose.rotation;
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const Eigen::Vector3d& p = pose.position;
  return fmt::format("{} {} {} {} {} {} {}", p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
}

}  // namespace bulletnav::bench
