// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim::shell {

/// The leaf of a door at its angle, with panels and a handle on both sides.
void AddLeaf(const HouseStyle& style, const Opening& door, MeshBuilder* builder);

}  // namespace bulletnav::sim::shell
