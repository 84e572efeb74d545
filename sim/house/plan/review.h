// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"

namespace bulletnav::sim::plan {

/// Whether people could live in a plan with its doors and windows: every bedroom has a wall for a
/// bed, the living room one for a sofa, the kitchen one for its cupboards and so on, and no
/// corridor runs on where it leads nowhere.
bool IsLivable(const FloorPlan& plan);

}  // namespace bulletnav::sim::plan
