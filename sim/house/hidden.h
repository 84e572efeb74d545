// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/mesh_builder.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Leaves out the triangles that nobody sees: whose front has other things within a few
/// centimetres in nearly every direction, wherever one looks from it. Undersides, backs against
/// walls, boards in boards. `glows` stays in step with the triangles. Returns how many.
std::size_t RemoveHidden(SceneMesh* mesh, std::vector<Glow>* glows);

}  // namespace bulletnav::sim
