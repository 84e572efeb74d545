// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/floor_plan.h"
#include "sim/scene/doors.h"

namespace bulletnav::sim {

/// Gives the leaves of a plan the angles that a scene's doors have: `doors` as ImportScene tells
/// them of the house with this plan, one a leaf in the plan's order. None leaves the plan as it is.
void TurnLeaves(const std::vector<DoorLeaf>& doors, FloorPlan* plan);

}  // namespace bulletnav::sim
