// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim::shell {

/// What is in and around the plan's pits: their sides and floors, flights, rails. Steps of a flight
/// that goes down begin `first_drop` below the edge, too deep for a body, or behind a rail; a
/// flight that goes up is shut off by a rail at its foot. So no walk leads out of the storey.
void AddPits(const FloorPlan& plan, const HouseStyle& style, MeshBuilder* builder);

}  // namespace bulletnav::sim::shell
