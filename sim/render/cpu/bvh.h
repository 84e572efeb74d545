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
  using Triangles = std::span<const std::array<Eigen::Vector3f, 3>>;

  explicit Bvh(Triangles triangles);

  /// Builds another tree beside, over the triangles from `first` on, and returns its top as nodes
  /// refer to their children. Their numbers are those in `triangles`.
  std::int32_t Graft(Triangles triangles, std::size_t first);
  /// A node that stands for one of two, see BvhNode; returns its number.
  std::int32_t AddDetail(std::int32_t fine, std::int32_t coarse, float error);

  std::vector<BvhNode> nodes;
  std::vector<BvhLeaf> leaves;
};

}  // namespace bulletnav::sim
