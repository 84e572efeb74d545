// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace bulletnav::sim {

inline constexpr int kBvhWidth = 8;

inline constexpr std::int32_t kDetailNode = -1;

/// Inner node: boxes of up to 8 children, side by side for SIMD. Missing children have empty boxes.
/// If `count` is kDetailNode: one of two that are drawn in the same place, child[1] where it is so
/// far away that an error of low[0][0] metres is less than half a pixel, child[0] nearer by.
struct alignas(64) BvhNode {
  float low[3][kBvhWidth];
  float high[3][kBvhWidth];
  std::int32_t child[kBvhWidth];  // index of a node, or ~index of a leaf
  std::int32_t count;
};

/// Up to 8 triangles, side by side; the last one is repeated to fill.
struct alignas(64) BvhLeaf {
  float corner[3][3][kBvhWidth];  // [corner][axis][triangle]
  std::int32_t id[kBvhWidth];
  std::int32_t count;
};

}  // namespace bulletnav::sim
