// SPDX-License-Identifier: MIT
// Lofts: one large room to live and work in, with columns, a bed behind a partition, a bath.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/building/kind.h"
#include "sim/house/building/rooms.h"
#include "sim/house/building/stairwell.h"
#include "sim/house/furnish.h"
#include "sim/house/placing/programs.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;

constexpr std::array kSide = {
    Cell{kBathroom, 2.0f, 3.2f, 0.0, 1, 1}, Cell{kStorage, 1.6f, 2.6f, 0.6, 0, 2},
    Cell{kLaundry, 1.8f, 2.8f, 0.5, 0, 1},  Cell{kBedroom, 3.2f, 4.8f, 0.5, 0, 2},
    Cell{kStudy, 2.8f, 4.2f, 0.4, 0, 1},    Cell{kStairwell, 3.0f, 4.5f, 0.6, 0, 1},
    Cell{kToilet, 1.2f, 1.6f, 0.3, 0, 1}};

void Lay(float area, Sketch* sketch, Rng* rng) {
  Block block;
  block.bands.push_back(
      {.depth = Draw(rng, 2.6, 4.0), .cells = kSide, .share = Draw(rng, 0.4, 0.9)});
  const float most = std::clamp(0.85f * std::sqrt(area), 6.5f, 15.0f);
  block.bands.push_back(
      {.depth = Draw(rng, 0.7 * static_cast<double>(most), static_cast<double>(most)),
       .hall = kStudio});
  float length = area / (block.bands[0].depth + block.bands[1].depth);
  if (length > 15.0f && rng->Chance(0.4)) {
    block.tail = End{kStudio, Draw(rng, 0.3, 0.45) * length};
    length -= block.tail->length;
  }
  block.length = std::max(7.5f, length);
  LayBlock(block, {{0, 0}, {1, 0}, {0, 1}}, -1, sketch, rng);
}

/// Screens or shelves across the far end that leave a way at one side. Returns where they stand.
float Screens(Hall* hall, bool at_left) {
  RoomFurnisher& room = hall->room();
  static constexpr std::array<std::string_view, 3> kScreens = {"partition", "glass_screen",
                                                               "book_gondola"};
  constexpr float kWide = 1.6f;
  const std::string_view screen = room.Pick(kScreens);
  const float u = hall->length() - Draw(hall->rng(), 3.4, 4.4);
  const float reach = Draw(hall->rng(), 0.55, 0.75) * hall->width();
  room.SetAlike(true);
  for (float at = 0.5f * kWide + 0.05f; at + 0.5f * kWide < reach; at += kWide + 0.01f) {
    const float v = at_left ? at : hall->width() - at;
    hall->Put(screen, u, v, Look::kLeft, {.width = kWide, .height = 2.0f});
  }
  room.SetAlike(false);
  return u;
}

/// A bed at the far end of the room, its head at the wall there or at the screens.
void BedZone(Hall* hall) {
  RoomFurnisher& room = hall->room();
  const bool at_left = room.Chance(0.5);
  const float screens = Screens(hall, at_left);
  const float v = (at_left ? 0.3f : 0.7f) * hall->width();
  const Placed* bed = hall->Put("double_bed", hall->length() - 0.05f, v, Look::kLeft);
  if (bed == nullptr) bed = hall->Put("double_bed", screens + 0.45f, v, Look::kRight);
  if (bed == nullptr) bed = room.AgainstWall("double_bed", {.far_from_doors = true});
  if (bed == nullptr) bed = room.InTheOpen("single_bed");
  if (bed == nullptr) return;
  for (const bool left : {true, false}) {
    const Placed* table = room.Beside(*bed, "nightstand", left);
    if (table != nullptr) room.OnTop(*table, "table_lamp");
  }
  room.AgainstWall("wardrobe", {.width = 2.2f, .min_width = 1.0f, .near = bed});
}

/// Worktops on a wall, an island, a table with chairs.
void KitchenZone(Hall* hall) {
  RoomFurnisher& room = hall->room();
  placing::FurnishWorktops(&room);
  const Placed* counter = nullptr;
  for (const Placed& placed : room.placed()) {
    if (placed.kind->name == "kitchen_sink_counter" || placed.kind->name == "stove") {
      counter = &placed;
    }
  }
  if (counter == nullptr) return;
  const Placed* island = room.InTheOpen("kitchen_island", {.width = 2.0f, .near = counter});
  if (island == nullptr) {
    island = room.InTheOpen("kitchen_island", {.width = 1.3f, .near = counter});
  }
  if (island != nullptr) {
    room.ChairsAround(*island, "bar_stool", 3);
    room.Light("pendant_lamp", island);
  }
  const Placed* table =
      room.InTheOpen("dining_table", {.width = 2.2f, .near = island != nullptr ? island : counter});
  if (table == nullptr) table = room.InTheOpen("round_dining_table", {.near = counter});
  if (table == nullptr) return;
  room.ChairsAround(*table, "dining_chair", 8);
  room.OnTop(*table, room.Chance(0.5) ? "bowl_of_fruit" : "vase");
}

/// A sofa, armchairs and a low table on a rug, out in the room before a screen or by themselves.
void SofaZone(Hall* hall, float u) {
  RoomFurnisher& room = hall->room();
  const float v = 0.5f * hall->width();
  const Look look = room.Chance(0.5) ? Look::kUp : Look::kDown;
  const float back = look == Look::kUp ? v - 1.3f : v + 1.3f;
  const Placed* sofa = hall->Put("sofa", u, back, look, {.width = 2.2f});
  if (sofa == nullptr) sofa = room.AgainstWall("sofa", {.width = 2.2f, .min_width = 1.4f});
  if (sofa == nullptr) return;
  const Eigen::Vector3f before = sofa->pose * Eigen::Vector3f(0.0f, 0.0f, 1.6f);
  const bool is_turned = std::abs(sofa->pose.linear()(0, 2)) > 0.5f;
  room.Rug("rug", {before.x(), before.z()}, Draw(hall->rng(), 2.4, 3.4), is_turned);
  const Placed* table = room.At(*sofa, "coffee_table", {0.0f, sofa->size.z() + 0.75f, 0.0f});
  static constexpr std::array<std::string_view, 3> kThings = {"books_pile", "candles", "vase"};
  if (table != nullptr) room.OnTops(*table, kThings, 2);
  for (const float side : {-1.0f, 1.0f}) {
    const float turn = side > 0.0f ? -0.5f * kHalfTurn : 0.5f * kHalfTurn;
    if (room.Chance(0.7)) {
      room.At(*sofa, "armchair", {side * 1.9f, sofa->size.z() + 0.7f, turn});
    }
  }
  room.Beside(*sofa, "floor_lamp", room.Chance(0.5));
  if (room.Chance(0.6)) {
    room.AgainstWall("tv_stand", {.width = 1.9f, .min_width = 1.2f, .facing = sofa});
  }
}

/// Things for work and play, whichever the room's people do.
void HobbyZone(Hall* hall) {
  RoomFurnisher& room = hall->room();
  switch (room.rng().Below(4)) {
    case 0:
      room.InTheOpen("easel");
      room.AgainstWall("workbench", {.width = 2.0f, .min_width = 1.2f});
      hall->Scatter("easel", hall->Inner(1.0f));
      break;
    case 1:
      room.AgainstWall("piano");
      room.NearWall("guitar");
      room.NearWall("guitar");
      break;
    case 2:
      room.NearWall("treadmill");
      room.NearWall("exercise_bike");
      break;
    default:
      hall->Scatter("meeting_table", hall->Inner(2.0f), {.width = 2.4f});
      room.NearWall("bicycle");
      break;
  }
  const Placed* desk =
      room.AgainstWallWithSeat("desk", "office_chair", {.width = 1.6f, .min_width = 1.1f});
  if (desk != nullptr) {
    static constexpr std::array<std::string_view, 2> kThings = {"laptop", "desk_lamp"};
    room.OnTops(*desk, kThings, 2);
  }
}

void FurnishStudio(RoomFurnisher* room) {
  Hall hall(room);
  BedZone(&hall);
  KitchenZone(&hall);
  if (hall.width() > 6.0f && room->Chance(0.75)) hall.Columns(Draw(hall.rng(), 3.8, 5.5));
  SofaZone(&hall, Draw(hall.rng(), 0.35, 0.5) * hall.length());
  HobbyZone(&hall);
  if (room->area() > 90.0f) {
    HobbyZone(&hall);
    SofaZone(&hall, Draw(hall.rng(), 0.12, 0.25) * hall.length());
  }
  static constexpr std::array<std::string_view, 5> kWalls = {"bookshelf", "sideboard", "low_shelf",
                                                             "display_cabinet", "console_table"};
  hall.AlongWalls(kWalls, 2 + static_cast<int>(room->area() / 25.0f), 1.8f);
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 40.0f); ++i) {
    room->NearWall(room->Chance(0.6) ? "tall_plant" : "potted_plant");
  }
  room->NearWall("coat_rack");
  if (room->Chance(0.5)) room->Radiators();
  if (room->Chance(0.4)) room->DressWindows(room->Chance(0.6));
  hall.Lights(room->Chance(0.5) ? "pendant_lamp" : "bay_lamp", 4.0f);
  placing::HangPictures(room, 3 + static_cast<int>(room->area() / 25.0f));
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kStudio) return FurnishStudio(room);
  if (type == kStairwell) return FurnishStairwell(room);
  FurnishHomeRoom(type, room);
}

constexpr std::array kFloors = {Surface{"oak_planks"},
                                Surface{"pine_planks"},
                                Surface{"grey_planks"},
                                Surface{"concrete"},
                                Surface{"oak_herringbone"},
                                Surface{"walnut_planks"},
                                Surface{"concrete", {196, 194, 190}}};
constexpr std::array kHard = {Surface{"concrete"}, Surface{"slate_tile"},
                              Surface{"white_hex_tile"}};
constexpr std::array kSoft = {Surface{"oak_planks"}, Surface{"plush_carpet", {150, 146, 140}}};
constexpr std::array kWalls = {Surface{"plaster_smooth"}, Surface{"plaster_rough", {236, 232, 224}},
                               Surface{"white_brick"}, Surface{"red_brick"},
                               Surface{"concrete", {220, 220, 216}}};
constexpr std::array kAccents = {Surface{"red_brick"}, Surface{"brown_brick"}, Surface{"concrete"},
                                 Surface{"plaster_smooth", {72, 88, 96}},
                                 Surface{"plaster_smooth", {150, 116, 90}}};
constexpr std::array kCeilings = {Surface{"plaster_smooth"}, Surface{"concrete"}, Surface{"pine"},
                                  Surface{"plaster_rough"}};
constexpr std::array kBooks = {StyleKind::kIndustrial, StyleKind::kModern,
                               StyleKind::kScandinavian};

constexpr BuildingKind kKind = {
    .name = "loft",
    .min_area_m2 = 100.0f,
    .max_area_m2 = 500.0f,
    .ceiling = {2.9f, 4.6f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.5},
    .lay = Lay,
    .furnish = Furnish,
    .pits = {kStudio, 0.25, false}};

}  // namespace

const BuildingKind& Loft() {
  return kKind;
}

}  // namespace bulletnav::sim::building
