// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

#include "sim/house/floor_plan.h"
#include "sim/house/furnishing.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"
#include "sim/house/refurnish.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

namespace placing {
class RoomFurnisher;
}

/// Furnishes every room of a house by its type: the pieces that tell what the room is, against the
/// walls where people put them, then rugs, curtains, lamps, pictures and small things.
/// Frame: the world; the floor is y = 0, the plan's (x, z).
/// Promises: pieces stand inside their rooms, not in each other, clear of doors and their swing and
/// not before windows; a body 0.4 m wide gets from every door of a room to every other.
/// Rooms are independent: one room's furniture does not depend on another's.
/// Returns the kinds that stand or hang in each room, in the order they were placed; small things
/// on tops, rugs, blinds and lamps on the ceiling are left out.
std::vector<std::vector<std::string_view>> FurnishHouse(const FloorPlan& plan,
                                                        const HouseStyle& style, const Rng& rng,
                                                        MeshBuilder* builder);

/// Furnishes every room by what `furnish` does with one of its type, some of them anew; else as
/// FurnishHouse. Returns what stands or hangs in the rooms, in the order of rooms and then of
/// placing.
std::vector<Furnishing> FurnishRooms(const FloorPlan& plan, const HouseStyle& style,
                                     void (*furnish)(RoomType, placing::RoomFurnisher*),
                                     const Rng& rng, MeshBuilder* builder,
                                     const Refurnish& refurnish = {});

/// What homes have in a room of a type.
void FurnishHomeRoom(RoomType type, placing::RoomFurnisher* room);

}  // namespace bulletnav::sim
