// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Fewer triangles that look like a patch of a mesh from afar. They use the mesh's own vertices.
struct CoarsePatch {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> like;  // the mesh's triangle that gives each its material and object
  /// Metres: how far the patch's vertices lie from the coarse surface, or its texture from where it
  /// was, at most.
  double error = 0.0;
};

/// Simplifies a patch of a mesh's triangles by at most `largest_error` metres, each material and
/// object by itself. All borders stay as they are, so that neighbours fit with and without. Colours
/// of vertices that would change by more than can be seen (6 of 255) keep their triangles. Nothing
/// if less than half of the triangles would go. Source: quadric error metrics (Garland and Heckbert
/// 1997), by meshoptimizer; the error is measured anew.
std::optional<CoarsePatch> Simplified(const SceneMesh& mesh,
                                      std::span<const std::uint32_t> triangles,
                                      double largest_error);

}  // namespace bulletnav::sim
