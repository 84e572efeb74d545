// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim::shell {

/// Frame, casings, leaf, handle and threshold of door or arch number `opening`.
void AddPassage(const FloorPlan& plan, const HouseStyle& style, std::size_t opening,
                MeshBuilder* builder);

/// Reveals, sill, frame, bars and outside view of a window.
void AddWindow(const HouseStyle& style, const Opening& window, MeshBuilder* builder);

}  // namespace bulletnav::sim::shell
