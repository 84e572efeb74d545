// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"

namespace bulletnav::sim::plan {

/// Whether a round body of some radius gets from the entry door into every room, past the door
/// leaves as they stand. On a raster of 5 cm, so leave some centimetres of slack.
bool IsPassable(const FloorPlan& plan, float radius);

}  // namespace bulletnav::sim::plan
