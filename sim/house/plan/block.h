// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/plan/draft.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// Divides a box among rooms in proportion to their targets: cut across again and again in random
/// order, or one room set into a corner of the living room, which then is L-shaped.
void SliceBlock(const Box& box, std::vector<int> rooms, Draft* draft, Rng* rng);

}  // namespace bulletnav::sim::plan
