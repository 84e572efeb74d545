// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/plan/strip.h"

namespace bulletnav::sim::plan {

/// Slots that stay side by side, such as a bedroom and the column with its bathroom.
struct Bundle {
  std::vector<Slot> slots;
  double privacy = 0.0;  // low: near the living room
};

/// Combines rooms into slots. Small rooms are too short for a whole strip's depth: they are put
/// behind each other (the far one entered from the room beside it), cut from a corner of a larger
/// room, or left to fill a slot of their own.
std::vector<Bundle> MakeBundles(const Draft& draft, const std::vector<int>& rooms, Rng* rng);

/// Spreads bundles over the strips that have a depth so that both come out about equally long,
/// public ones first. Slots already there stay in front.
void Distribute(const Draft& draft, std::vector<Bundle> bundles, Strip* north, Strip* south,
                Rng* rng);

}  // namespace bulletnav::sim::plan
