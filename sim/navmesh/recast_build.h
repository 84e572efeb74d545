// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/navmesh/navmesh.h"

namespace bulletnav::sim {

/// A packed navmesh.
struct DetourTile {
  std::vector<std::uint8_t> bytes;  // empty if nothing is walkable
  bool is_open = false;             // next to nothing is indoors, so that all counts as floor
};

/// Runs Recast over the mesh and packs the result as one Detour tile.
/// Polygons that are no floor have no flags.
/// Throws Error if the scene has more cells than fit into memory.
DetourTile BuildDetourTile(const SceneMesh& mesh, const NavmeshSpec& spec);

}  // namespace bulletnav::sim
