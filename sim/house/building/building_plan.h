// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/building/kind.h"
#include "sim/house/floor_plan.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::building {

/// How large a building may be, square metres of clear floor; 0 leaves it to the kind.
struct AreaLimits {
  float min_m2 = 0.0f;
  float max_m2 = 0.0f;
};

/// Throws Error where limits are not within the kind's or leave less than a fifth of play.
void CheckLimits(const BuildingKind& kind, const AreaLimits& limits);

/// Draws the layout of one storey of a kind's building: its bands, doors, windows.
/// Frame: the world's (x, z), the footprint's centre at the origin.
/// Promises, as GenerateFloorPlan: rooms and walls tile the footprint, every room is reachable from
/// the entry door by a body of radius 0.18 m; the floor lies within the limits.
/// Throws as CheckLimits.
FloorPlan GenerateBuildingPlan(const BuildingKind& kind, const Rng& rng, AreaLimits limits = {});

}  // namespace bulletnav::sim::building
