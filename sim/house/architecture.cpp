// SPDX-License-Identifier: MIT
#include "sim/house/architecture.h"

#include "sim/base/check.h"
#include "sim/house/shell/door_leaf.h"
#include "sim/house/shell/openings.h"
#include "sim/house/shell/pits.h"
#include "sim/house/shell/room_shell.h"

namespace bulletnav::sim {

void BuildArchitecture(const FloorPlan& plan, const HouseStyle& style, MeshBuilder* builder) {
  BULLETNAV_CHECK_EQ(plan.rooms.size(), style.rooms.size());
  BULLETNAV_CHECK_EQ(plan.openings.size(), style.thresholds.size());
  for (int room = 0; room < static_cast<int>(plan.rooms.size()); ++room) {
    shell::AddFloorAndCeiling(plan, style, room, builder);
    shell::AddWalls(plan, style, room, builder);
  }
  shell::AddPits(plan, style, builder);
  for (std::size_t i = 0; i < plan.openings.size(); ++i) {
    const Opening& opening = plan.openings[i];
    const std::string& room = plan.rooms[static_cast<std::size_t>(opening.room_a)].name;
    if (opening.IsPassage()) {
      builder->BeginObject("door_frame", room);
      shell::AddPassage(plan, style, i, builder);
    } else {
      builder->BeginObject("window", room);
      shell::AddWindow(style, opening, builder);
    }
    if (!opening.has_leaf) continue;
    builder->BeginObject("door", room);
    shell::AddLeaf(style, opening, builder);
  }
}

}  // namespace bulletnav::sim
