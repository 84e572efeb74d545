// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "sim/navmesh/navmesh.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {

/// What `scenes inspect` says of a scene.
struct SceneReport {
  sim::ImportReport import;
  int islands = 0;
  bool is_open = false;  // nothing is indoors, see sim::Navmesh::is_open
  float walkable_m2 = 0.0f;
  /// Length of the longest shortest path found on the largest island: farthest point of the
  /// farthest point, a lower bound that is mostly exact.
  double longest_geodesic_m = 0.0;
  std::vector<sim::DoorLeaf> doors = {};
};

SceneReport InspectScene(const sim::ImportReport& import, const sim::Navmesh& navmesh);

/// Keys: triangles, materials, textures_found, textures_missing (numbers), extent_m [3], up_axis
/// ("y" or "z", as read: COLLADA files are turned by their own element while they are), islands,
/// walkable_m2, is_open, longest_geodesic_m, skipped [texts], missing_textures [texts]; where
/// doors are known, doors [{object, hinge [x, y, z], axis [x, y, z], width_m, angle_deg, open,
/// leads_outside}].
std::string ToJson(const SceneReport& report);
/// The same for people, a line each.
std::string ToText(const SceneReport& report);

}  // namespace bulletnav::bench
