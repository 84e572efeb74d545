// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/plan/judge.h"

namespace bulletnav::sim::plan {

/// Turns a draft into a plan in metres around the origin: outlines and names of the rooms, walls,
/// footprint; `openings` (in the draft's frame) move along.
FloorPlan Assemble(const Layout& layout, std::vector<Opening> openings);

/// Mirrors and quarter turns, so that no direction is special: bit 0 mirrors x, bit 1 mirrors z,
/// bit 2 swaps the axes.
void Turn(int how, FloorPlan* plan);

}  // namespace bulletnav::sim::plan
