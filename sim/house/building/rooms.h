// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/building/hall.h"

namespace bulletnav::sim::building {

/// What rooms look like that many kinds of buildings have.
/// `second_mirrors`: one more hangs above the mirror that each basin brings, as offices, workshops
/// and warehouses have had it from the first, so that their seeds keep giving the same buildings.
void FurnishRestroom(RoomFurnisher* room, bool second_mirrors = false);
void FurnishBreakRoom(RoomFurnisher* room);
void FurnishStockRoom(RoomFurnisher* room);
void FurnishTechnicalRoom(RoomFurnisher* room);
void FurnishPassage(RoomFurnisher* room);
/// A counter, seats, a plant: lobbies, receptions.
void FurnishLobby(RoomFurnisher* room);
void FurnishOffice(RoomFurnisher* room);
void FurnishMeetingRoom(RoomFurnisher* room);

/// Blinds or none, panels or tubes on the ceiling by its height, an exit sign.
void FinishRoom(RoomFurnisher* room);

}  // namespace bulletnav::sim::building
