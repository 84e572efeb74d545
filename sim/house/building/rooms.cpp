// SPDX-License-Identifier: MIT
#include "sim/house/building/rooms.h"

#include <algorithm>
#include <array>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::building {
namespace {

constexpr float kHighCeiling = 3.7f;  // metres; bells hang from higher ones

}  // namespace

void FinishRoom(RoomFurnisher* room) {
  if (room->Chance(0.4)) room->DressWindows(false);
  Hall hall(room);
  const float ceiling = room->space().ceiling();
  if (ceiling > kHighCeiling) {
    hall.Lights(room->Chance(0.6) ? "bay_lamp" : "tube_lamp", 0.9f * ceiling);
  } else {
    hall.Lights(room->Chance(0.5) ? "panel_lamp" : "tube_lamp",
                room->area() > 150.0f ? 3.4f : 2.6f);
  }
  if (room->Chance(0.5)) room->OnWall("fire_extinguisher", 0.8f);
}

void FurnishRestroom(RoomFurnisher* room, bool second_mirrors) {
  const int stalls = std::max(1, static_cast<int>(room->area() / 5.0f));
  for (int i = 0; i < stalls; ++i) {
    room->SetAlike(true);
    if (room->AgainstWall("toilet_stall", {.anchor = placing::Anchor::kEnd}) == nullptr) {
      room->SetAlike(false);
      room->AgainstWall("toilet");
    }
  }
  room->SetAlike(true);
  for (int i = 0; i < std::max(1, stalls - 1); ++i) {
    const Placed* basin = room->AgainstWall("washbasin", {.width = 0.6f});
    if (basin != nullptr && second_mirrors) room->Over(*basin, "mirror", 0.3f);
  }
  room->SetAlike(false);
  room->NearWall("bin");
  FinishRoom(room);
}

void FurnishBreakRoom(RoomFurnisher* room) {
  placing::FurnishWorktops(room);
  const int tables = std::max(1, static_cast<int>(room->area() / 12.0f));
  for (int i = 0; i < tables; ++i) {
    const Placed* table =
        room->InTheOpen(room->Chance(0.5) ? "round_dining_table" : "dining_table", {.width = 1.3f});
    if (table != nullptr) room->ChairsAround(*table, "dining_chair", 4);
  }
  if (room->Chance(0.6)) room->AgainstWall("vending_machine");
  if (room->Chance(0.6)) room->NearWall("water_cooler");
  if (room->area() > 18.0f && room->Chance(0.5)) room->AgainstWall("sofa");
  room->NearWall("bin");
  room->OnWall("pin_board");
  FinishRoom(room);
}

void FurnishStockRoom(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.width() > 4.5f) {
    hall.Fill(
        {.kind = "store_rack", .width = 1.8f, .pitch = 1.9f, .break_after = 5.4f, .share = 0.9f},
        hall.Inner(1.0f));
  }
  const int shelves = 2 + static_cast<int>(room->area() / 6.0f);
  for (int i = 0; i < shelves; ++i) {
    room->AgainstWall("utility_shelf", {.width = 1.8f, .min_width = 0.8f, .far_from_doors = true});
  }
  room->AgainstWall("box_stack");
  if (room->Chance(0.6)) room->AgainstWall("box_stack");
  if (room->Chance(0.5)) room->NearWall("step_ladder");
  if (room->Chance(0.5)) room->AgainstWall("cleaning_set");
  FinishRoom(room);
}

void FurnishTechnicalRoom(RoomFurnisher* room) {
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 5.0f); ++i) {
    room->AgainstWall("locker_row", {.width = 1.4f, .min_width = 0.8f, .far_from_doors = true});
  }
  if (room->Chance(0.7)) room->OnWall("boiler", 0.9f);
  room->AgainstWall("cleaning_set");
  FinishRoom(room);
}

void FurnishPassage(RoomFurnisher* room) {
  static constexpr std::array<std::string_view, 5> kThings = {
      "bench", "water_cooler", "potted_plant", "vending_machine", "credenza"};
  const int pieces = static_cast<int>(room->area() / 25.0f);
  for (int i = 0; i < pieces; ++i) {
    const std::string_view kind = room->Pick(kThings);
    const bool is_free = FindFurniture(kind).placement == Placement::kFree;
    if (is_free) {
      room->NearWall(kind);
    } else {
      room->AgainstWall(kind, {.width = 1.4f, .min_width = 0.8f});
    }
  }
  for (int i = 0; i < static_cast<int>(room->area() / 12.0f); ++i) {
    room->OnWall(room->Chance(0.5) ? "poster" : "pin_board");
  }
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void FurnishLobby(RoomFurnisher* room) {
  Hall hall(room);
  if (room->area() > 120.0f) hall.Columns(6.0f);
  const float wide = std::min(4.5f, 0.4f * hall.length());
  const bool at_end = room->Chance(0.5);
  const Placed* counter = nullptr;
  if (at_end) {
    counter = hall.Put("service_counter", hall.length() - 1.8f, 0.5f * hall.width(), Look::kLeft,
                       {.width = std::min(wide, hall.width() - 2.6f)});
  }
  if (counter == nullptr) {
    counter = hall.Put("service_counter", 0.5f * hall.length(), 1.7f, Look::kUp, {.width = wide});
  }
  if (counter != nullptr) room->At(*counter, "office_chair", {0.0f, -0.85f, 0.0f});
  const int seats = 1 + static_cast<int>(room->area() / 25.0f);
  for (int i = 0; i < seats; ++i) {
    const Placed* seat = room->AgainstWall(room->Chance(0.6) ? "sofa" : "armchair");
    if (seat != nullptr && room->Chance(0.6)) room->Before(*seat, "coffee_table", 0.4f);
  }
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 30.0f); ++i) {
    room->NearWall(room->Chance(0.5) ? "tall_plant" : "potted_plant");
  }
  placing::HangPictures(room, 2);
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void FurnishOffice(RoomFurnisher* room) {
  const int desks = std::max(1, static_cast<int>(room->area() / 9.0f));
  room->SetAlike(room->Chance(0.6));
  for (int i = 0; i < desks; ++i) {
    const placing::Wish wish{.width = 1.6f, .min_width = 1.1f, .squeeze = i == 0};
    if (room->AgainstWallWithSeat("desk", "office_chair", wish) == nullptr) break;
  }
  room->SetAlike(false);
  room->AgainstWall(room->Chance(0.6) ? "credenza" : "bookshelf",
                    {.width = 1.8f, .min_width = 0.8f});
  if (room->area() > 16.0f) {
    const Placed* table = room->InTheOpen("round_dining_table");
    if (table != nullptr) room->ChairsAround(*table, "dining_chair", 4);
  }
  room->AgainstWall("filing_cabinet");
  room->NearWall("bin");
  if (room->Chance(0.5)) room->NearWall("potted_plant");
  room->OnWall(room->Chance(0.5) ? "whiteboard" : "pin_board", 0.0f, {.width = 1.4f});
  FinishRoom(room);
}

void FurnishMeetingRoom(RoomFurnisher* room) {
  Hall hall(room);
  const float wide = std::min(6.0f, hall.length() - 2.4f);
  if (wide >= 1.6f)
    hall.Put("meeting_table", 0.5f * hall.length(), 0.5f * hall.width(), Look::kUp,
             {.width = wide});
  room->OnWall(room->Chance(0.5) ? "wall_tv" : "whiteboard", 0.9f);
  room->AgainstWall("credenza", {.width = 1.6f, .min_width = 0.8f});
  if (room->Chance(0.5)) room->NearWall("potted_plant");
  placing::HangPictures(room, 1);
  FinishRoom(room);
}

}  // namespace bulletnav::sim::building
