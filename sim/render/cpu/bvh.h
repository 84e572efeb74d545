// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/render/kernels/bvh_layout.h"

namespace bulletnav::sim {

/// Bounding volume hierarchy over triangles, 8 wide, built by Embree's builder with one thread, so
/// that the same triangles always give the same tree. nodes[0] is the root.
struct Bvh {
  explicit Bvh(std::span<const std::array<Eigen::Vector3f, 3>> triangles);

  std::vector<BvhNode> nodes;
  std::vector<BvhLeaf> leaves;
};

}  // namespace bulletnav::sim
