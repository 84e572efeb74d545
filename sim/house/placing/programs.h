// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/placing/room_furnisher.h"

namespace bulletnav::sim::placing {

/// What stands in rooms of one type, the most telling first.
void FurnishLivingRoom(RoomFurnisher* room);
void FurnishDiningRoom(RoomFurnisher* room);
void FurnishKitchen(RoomFurnisher* room);
void FurnishBedroom(RoomFurnisher* room);
void FurnishKidsRoom(RoomFurnisher* room);
void FurnishBathroom(RoomFurnisher* room);
void FurnishToilet(RoomFurnisher* room);
void FurnishCorridor(RoomFurnisher* room);
void FurnishEntry(RoomFurnisher* room);
void FurnishStudy(RoomFurnisher* room);
void FurnishLaundry(RoomFurnisher* room);
void FurnishStorage(RoomFurnisher* room);

/// A row of worktops with sink, stove and refrigerator on the best wall.
void FurnishWorktops(RoomFurnisher* room);

/// `count` pictures and the like on free walls.
void HangPictures(RoomFurnisher* room, int count);

}  // namespace bulletnav::sim::placing
