// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <recastnavigation/Recast.h>

#include "sim/navmesh/indoors.h"

namespace bulletnav::sim {

/// Which regions are no floor, by their number. Regions between which a body can walk are judged
/// together:
/// - a roof is uncovered, with floor to stand on below, on at least half of it; a gallery that
/// steps
///   lead to is not, since it is judged together with what lies below;
/// - a top (of a bed, a table, a shelf) has no floor to stand on below on half of it, drops to one
///   larger part of the floor along at least 15% of its border, is smaller than that part, and has
///   at most 10 m2 or a quarter of that part.
/// Source: ours.
std::vector<bool> RegionsOffTheFloor(const rcHeightfield& heights,
                                     const rcCompactHeightfield& compact,
                                     const std::vector<Surroundings>& surroundings,
                                     int radius_cells);

}  // namespace bulletnav::sim
