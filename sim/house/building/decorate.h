// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/building/kind.h"
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::building {

/// Draws the surfaces of a building. Rooms of one type look alike, as they do in offices and
/// hotels, but for the colour of some walls; how much they differ is drawn too.
HouseStyle DrawBuildingStyle(const BuildingKind& kind, const FloorPlan& plan, const Rng& rng);

}  // namespace bulletnav::sim::building
