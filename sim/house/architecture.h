// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim {

/// Builds the shell of a house: floors, ceilings, walls with their holes and reveals, baseboards,
/// mouldings and beams, doors with frames, leaves at their angle and handles, thresholds, windows
/// with frames, sills and a picture of the outside that gives light (Glow::kSky).
/// Frame: the world; the floor is y = 0, the plan's (x, z).
/// Promises: closed all around: walls run on below the floor and above the ceiling, which run on
/// under the walls, so that no ray from a room gets out. Walls are few large faces, cut along the
/// jambs, sills and heads of their openings.
/// Expects: a style with the plan's rooms and openings (checked).
void BuildArchitecture(const FloorPlan& plan, const HouseStyle& style, MeshBuilder* builder);

}  // namespace bulletnav::sim
