// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Those triangles of a mesh, in their order, with the vertices, materials, textures and objects
/// that they use and no others. Expects: at least one triangle, all in range.
SceneMesh Submesh(const SceneMesh& mesh, const std::vector<std::size_t>& triangles);

}  // namespace bulletnav::sim
