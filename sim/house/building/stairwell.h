// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/building/hall.h"
#include "sim/house/building/kind.h"
#include "sim/house/floor_plan.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::building {

/// Digs a pit into every stairwell, where one fits beside its doors, and into large rooms as
/// `habit` says; with rails or without, with flights or none. Does nothing to plans that have no
/// such rooms. Whether every room is still reachable is for the caller to see.
void DigPits(const PitHabit& habit, const Rng& rng, FloorPlan* plan);

/// What little stands and hangs in a stairwell.
void FurnishStairwell(RoomFurnisher* room);

}  // namespace bulletnav::sim::building
