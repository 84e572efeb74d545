// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/report/side_column.h"

namespace bulletnav::bench {

/// What the signs mean that an episode's picture shows on a map, and no others. `belief`: whether
/// what the agent believes is drawn.
std::vector<LegendEntry> LegendOf(const EpisodeTrajectory& trajectory, const MapPlace& place,
                                  bool belief);

}  // namespace bulletnav::bench
