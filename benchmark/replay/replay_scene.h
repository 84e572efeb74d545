// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/report/scene_map.h"

namespace bulletnav::bench {

/// A storey for the page to draw, as JSON. Metres; points are world x, z:
///   low, size  the corner of least coordinates, and the extent
///   picture    data URI: furniture in muted colours over that extent, clear elsewhere
///   walk       corners of triangles of walkable floor: [x, z, ...]
///   cuts       ends of lines where walls are cut: [x, z, x, z, ...]; of scenes without a plan
///   walls      [[ax, az, bx, bz, thickness]];  rooms [[x, z, ...]];  names [[text, x, z]]
///   holes      [[ax, az, bx, bz, thickness, bottom, top, 1 if a passage]];  leaves [[x, z, ...]]
std::string SceneJson(const SceneMap& map);

}  // namespace bulletnav::bench
