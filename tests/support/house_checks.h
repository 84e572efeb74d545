// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "sim/house/floor_plan.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::tests {

inline constexpr float kCountedFloor =
    0.5f;  // metres; tops of beds and tables are no floor of a room

/// Share of the walkable floor, furniture tops left out, that hangs together.
inline float ConnectedShare(const sim::Navmesh& navmesh) {
  const auto& corners = navmesh.triangle_corners();
  float all = 0.0f;
  float main = 0.0f;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    const Eigen::Vector3f& a = corners[3 * t];
    if (std::abs(a.y()) > kCountedFloor) continue;  // nor are the floors of pits
    const float area = 0.5f * (corners[3 * t + 1] - a).cross(corners[3 * t + 2] - a).norm();
    all += area;
    if (navmesh.triangle_islands()[t] == 0) main += area;
  }
  return main / all;
}

/// Whether some place of a room is on the largest island.
inline bool IsReachable(const sim::Room& room, const sim::NavmeshQuery& query) {
  Eigen::AlignedBox2f box;
  for (const sim::PlanPoint& p : room.outline) box.extend(p);
  for (float x = box.min().x(); x < box.max().x(); x += 0.1f) {
    for (float z = box.min().y(); z < box.max().y(); z += 0.1f) {
      if (!sim::IsInside(room.outline, {x, z})) continue;
      const auto island = query.IslandOf({x, 0.0f, z});
      if (island && *island == 0) return true;
    }
  }
  return false;
}

}  // namespace bulletnav::tests
