// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/navmesh/navmesh.h"

namespace bulletnav::sim {

/// Runs Recast over the mesh and packs the result as one Detour tile; empty if nothing is walkable.
/// Polygons that are no floor have no flags.
/// Throws Error if the scene has more cells than fit into memory.
std::vector<std::uint8_t> BuildDetourTile(const SceneMesh& mesh, const NavmeshSpec& spec);

}  // namespace bulletnav::sim
