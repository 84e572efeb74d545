// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "sim/house/floor_plan.h"

namespace bulletnav::sim::plan {

/// Four corners of a convex figure in order around it.
using Quad = std::array<PlanPoint, 4>;

/// Whether two quads come nearer to each other than `gap`, tested along the directions of their
/// sides: exact for overlap, on the safe side for gaps at corners.
bool AreClose(const Quad& a, const Quad& b, float gap);

/// The ground in front of an opening and behind it, `reach` beyond the wall's faces.
Quad ApproachZone(const Opening& opening, float reach);

}  // namespace bulletnav::sim::plan
