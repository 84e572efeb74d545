// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "benchmark/report/top_down.h"
#include "sim/house/floor_plan.h"

namespace bulletnav::bench {

/// The point of a polygon farthest from its sides, to 5 cm; among equally good ones that nearest to
/// the middle of its box. In an L-shaped room the middle may well be outside, this never is.
Eigen::Vector2f PoleOfInaccessibility(std::span<const Eigen::Vector2f> outline);

/// The room in whose outline a point lies; null if there is none, as in a doorway.
const sim::Room* RoomAt(const sim::FloorPlan& plan, const sim::PlanPoint& point);

/// The rooms' types in plain words ("living room"), each where it is to be printed in its room.
std::vector<MapLabel> RoomLabels(const sim::FloorPlan& plan);

}  // namespace bulletnav::bench
