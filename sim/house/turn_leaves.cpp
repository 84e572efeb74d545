// SPDX-License-Identifier: MIT
#include "sim/house/turn_leaves.h"

namespace bulletnav::sim {

void TurnLeaves(const std::vector<DoorLeaf>& doors, FloorPlan* plan) {
  auto door = doors.begin();
  for (Opening& opening : plan->openings) {
    if (!opening.has_leaf || door == doors.end()) continue;
    opening.door_angle = (door++)->angle;
  }
}

}  // namespace bulletnav::sim
