// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Halves edges of a mesh until `should_split(a, b)` holds for none, at most `rounds` times.
/// Whether an edge is halved depends on its two ends alone, so faces that meet in it stay joined
/// without gaps. New vertices lie in the middle, in position, texture and colour. `tag` is anything
/// kept per triangle, in step with the triangles. Expects: should_split symmetric in its vertices'
/// positions and normals.
void RefineEdges(SceneMesh* mesh, std::vector<int>* tag, int rounds,
                 const std::function<bool(std::uint32_t a, std::uint32_t b)>& should_split);

}  // namespace bulletnav::sim
