// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::placing {
namespace {

constexpr std::array<std::string_view, 9> kCounterClutter = {
    "kettle", "toaster", "coffee_machine", "knife_block", "cutting_board",
    "pot",    "plates",  "bowl_of_fruit",  "bottles"};

bool PlaceIsland(RoomFurnisher* room) {
  const Placed* island = room->InTheOpen("kitchen_island", {.width = 1.6f});
  if (island == nullptr) return false;
  room->OnTops(*island, kCounterClutter, 2);
  for (const float x : {-0.4f, 0.4f}) {
    room->At(*island, "bar_stool", {x, -0.5f * island->size.z() - 0.3f, 0.0f});
  }
  room->Light("pendant_lamp", island);
  return true;
}

void PlaceTable(RoomFurnisher* room) {
  if (room->area() < 11.0f) return;
  if (room->area() > 14.0f && room->Chance(0.5) && PlaceIsland(room)) return;
  const std::string_view kind = room->Chance(0.5) ? "round_dining_table" : "dining_table";
  const Placed* table = room->InTheOpen(kind, {.width = 1.3f});
  if (table == nullptr) return;
  room->ChairsAround(*table, "dining_chair", 4);
  room->OnTop(*table, "bowl_of_fruit");
}

}  // namespace

void FurnishKitchen(RoomFurnisher* room) {
  FurnishWorktops(room);
  room->AgainstWall("pantry_shelf", {.width = 1.2f, .min_width = 0.6f});
  PlaceTable(room);
  const Placed* counter = room->AgainstWall("kitchen_counter", {.width = 1.6f, .min_width = 0.6f});
  if (counter != nullptr) {
    room->OnTop(*counter, "microwave");
    room->OnTops(*counter, kCounterClutter, 3);
  } else {
    room->AgainstWall("microwave_shelf");
  }
  room->NearWall("bin");
  if (room->Chance(0.4)) room->NearWall("potted_plant");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
  room->OnWall("wall_clock", 1.75f);
  if (room->Chance(0.6)) room->OnWall("wall_shelf", 1.4f);
  room->OnWall(room->Chance(0.5) ? "painting" : "poster");
}

}  // namespace bulletnav::sim::placing
