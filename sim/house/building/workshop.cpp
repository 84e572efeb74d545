// SPDX-License-Identifier: MIT
// Workshops: joiners, metal workers, garages; benches, machines, bays for vehicles, a paint room.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/building/kind.h"
#include "sim/house/building/rooms.h"
#include "sim/house/building/stairwell.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;
constexpr OpeningKind kArch = OpeningKind::kArch;

constexpr std::array kSide = {
    Cell{kRestroom, 2.4f, 3.5f, 0.0, 1, 1},  Cell{kOffice, 2.8f, 4.5f, 0.8, 1, 3},
    Cell{kStockRoom, 3.0f, 6.0f, 1.0, 0, 3}, Cell{kBreakRoom, 3.4f, 5.5f, 0.4, 0, 1},
    Cell{kStairwell, 3.2f, 5.0f, 0.5, 0, 1}, Cell{kTechnicalRoom, 2.2f, 3.4f, 0.4, 0, 1},
    Cell{kPaintRoom, 4.5f, 8.0f, 0.7, 0, 1}};
constexpr std::array kBays = {Cell{kWorkshop, 6.0f, 12.0f, 1.0, 1, 6, kArch},
                              Cell{kPaintRoom, 5.0f, 8.0f, 0.4, 0, 1},
                              Cell{kStockRoom, 3.2f, 6.0f, 0.5, 0, 2}};

void Lay(float area, Sketch* sketch, Rng* rng) {
  Block block;
  block.bands.push_back(
      {.depth = Draw(rng, 3.4, 5.0), .cells = kSide, .share = Draw(rng, 0.55, 1.0)});
  const bool has_bays = area > 350.0f && rng->Chance(0.5);
  const float most = std::clamp(0.75f * std::sqrt(area), 7.0f, has_bays ? 9.0f : 18.0f);
  block.bands.push_back(
      {.depth = Draw(rng, 0.75 * static_cast<double>(most), static_cast<double>(most)),
       .hall = kWorkshop});
  if (has_bays) block.bands.push_back({.depth = Draw(rng, 6.0, 9.0), .cells = kBays});
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  float length = area / depth;
  if (length > 16.0f && rng->Chance(0.5)) {
    block.tail = End{kWorkshop, Draw(rng, 0.25, 0.45) * length};
    length -= block.tail->length;
  }
  block.length = std::max(8.5f, length);
  LayBlock(block, {{0, 0}, {1, 0}, {0, 1}}, -1, sketch, rng);
}

/// Cars side by side, some places empty.
void FurnishGarage(Hall* hall) {
  RoomFurnisher& room = hall->room();
  const float pitch = Draw(hall->rng(), 3.2, 4.0);
  const auto bays = std::max(1, static_cast<int>((hall->length() - 2.0f) / pitch));
  const bool turned = hall->width() > 7.0f;  // fronts along the hall's shorter side
  for (int i = 0; i < (turned ? bays : std::max(1, bays / 2)); ++i) {
    if (!room.Chance(0.75)) continue;
    const float step = turned ? pitch : 2.0f * pitch;
    const float u = 1.0f + step * (static_cast<float>(i) + 0.5f);
    const float v = turned ? std::min(0.5f * hall->width(), 4.2f) : 0.5f * hall->width();
    // A car's length is its x, so it looks aside of where it heads.
    const Look look = turned ? (room.Chance(0.5) ? Look::kRight : Look::kLeft)
                             : (room.Chance(0.5) ? Look::kUp : Look::kDown);
    hall->Put("car", u, v, look, {.width = Draw(hall->rng(), 3.7, 4.7)});
  }
  for (int i = 0; i < 2 + static_cast<int>(room.area() / 50.0f); ++i) {
    hall->Scatter("tool_cart", hall->Inner(0.9f));
  }
  static constexpr std::array<std::string_view, 5> kWalls = {
      "workbench", "utility_shelf", "workbench", "locker_row", "box_stack"};
  hall->AlongWalls(kWalls, 3 + static_cast<int>(room.area() / 22.0f), 2.2f);
  for (int i = 0; i < 2; ++i) room.NearWall("drums");
}

void FurnishMetalShop(Hall* hall) {
  RoomFurnisher& room = hall->room();
  static constexpr std::array<std::string_view, 4> kMachines = {"lathe", "press", "machine",
                                                                "drill_press"};
  const Field field = hall->Inner(1.6f);
  const auto rows = std::max(1, static_cast<int>((field.v1 - field.v0) / 2.6f));
  for (int row = 0; row < rows; ++row) {
    const float share = (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
    const float v = field.v0 + (field.v1 - field.v0) * share;
    hall->Fill({.kind = room.Pick(kMachines),
                .width = 2.0f,
                .pitch = 3.0f,
                .gap = Draw(hall->rng(), 1.0, 2.0),
                .share = 0.8f},
               {field.u0, field.u1, v - 0.4f, v + 0.4f});
  }
  static constexpr std::array<std::string_view, 4> kWalls = {"workbench", "workbench",
                                                             "utility_shelf", "locker_row"};
  hall->AlongWalls(kWalls, 3 + static_cast<int>(room.area() / 20.0f), 2.4f);
  for (int i = 0; i < 3; ++i) room.NearWall(room.Chance(0.5) ? "drums" : "pallet_stack");
  hall->Scatter("tool_cart", hall->Inner(1.0f));
  if (room.area() > 60.0f && room.Chance(0.6)) {
    for (int i = 0; i < 3; ++i) hall->Scatter("partition", hall->Inner(1.2f), {.width = 2.0f});
  }
}

void FurnishJoinery(Hall* hall) {
  RoomFurnisher& room = hall->room();
  static constexpr std::array<std::string_view, 3> kMachines = {"table_saw", "drill_press",
                                                                "goods_table"};
  const int pieces = 3 + static_cast<int>(room.area() / 18.0f);
  for (int i = 0; i < pieces; ++i) {
    hall->Scatter(i % 3 == 0 ? "table_saw" : room.Pick(kMachines), hall->Inner(1.7f));
  }
  hall->Fill({.kind = "store_rack", .width = 1.8f, .pitch = 3.0f, .share = 0.7f},
             {hall->length() - 3.2f, hall->length() - 1.2f, 1.2f, hall->width() - 1.2f});
  static constexpr std::array<std::string_view, 3> kWalls = {"workbench", "workbench",
                                                             "utility_shelf"};
  hall->AlongWalls(kWalls, 4 + static_cast<int>(room.area() / 16.0f), 2.2f);
  for (int i = 0; i < 3; ++i) room.NearWall(room.Chance(0.4) ? "step_ladder" : "pallet_stack");
}

void FurnishWorkshop(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.width() > 10.0f && room->Chance(0.6)) hall.Columns(Draw(hall.rng(), 5.5, 8.0));
  const int trade = room->rng().Below(3);
  if (trade == 0) {
    FurnishGarage(&hall);
  } else if (trade == 1) {
    FurnishMetalShop(&hall);
  } else {
    FurnishJoinery(&hall);
  }
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 50.0f); ++i) {
    room->OnWall("tool_wall", 1.0f, {.width = 2.0f});
  }
  room->OnWall("exit_sign", 2.3f);
  FinishRoom(room);
}

/// Something to be painted in the middle, paint along the walls.
void FurnishPaintRoom(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.length() > 6.4f && hall.width() > 3.6f && room->Chance(0.7)) {
    hall.Put("car", 0.5f * hall.length(), 0.5f * hall.width(), Look::kUp, {.width = 3.9f});
  } else {
    room->InTheOpen("goods_table", {.width = 1.4f});
  }
  static constexpr std::array<std::string_view, 3> kWalls = {"utility_shelf", "workbench",
                                                             "locker_row"};
  hall.AlongWalls(kWalls, 3, 1.6f);
  room->NearWall("drums");
  room->NearWall("step_ladder");
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kWorkshop) return FurnishWorkshop(room);
  if (type == kPaintRoom) return FurnishPaintRoom(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room, true);
  if (type == kStockRoom) return FurnishStockRoom(room);
  if (type == kStairwell) return FurnishStairwell(room);
  FurnishTechnicalRoom(room);
}

constexpr std::array kFloors = {Surface{"concrete"}, Surface{"concrete", {150, 148, 144}},
                                Surface{"concrete", {120, 138, 130}},
                                Surface{"concrete", {170, 120, 104}}, Surface{"pine_planks"}};
constexpr std::array kHard = {Surface{"concrete"}, Surface{"grey_large_tile"}};
constexpr std::array kSoft = {Surface{"vinyl_floor"}, Surface{"loop_carpet", {104, 104, 108}}};
constexpr std::array kWalls = {Surface{"plaster_rough"},
                               Surface{"plaster_rough", {214, 210, 200}},
                               Surface{"white_brick"},
                               Surface{"red_brick"},
                               Surface{"corrugated_metal", {206, 210, 212}},
                               Surface{"concrete", {226, 226, 222}}};
constexpr std::array kAccents = {Surface{"plaster_rough", {92, 118, 140}},
                                 Surface{"plaster_rough", {120, 140, 104}}, Surface{"red_brick"},
                                 Surface{"concrete"}};
constexpr std::array kCeilings = {Surface{"concrete"}, Surface{"corrugated_metal", {190, 190, 188}},
                                  Surface{"plaster_rough"}, Surface{"pine"}};
constexpr std::array kBooks = {StyleKind::kIndustrial, StyleKind::kModern,
                               StyleKind::kScandinavian};

constexpr BuildingKind kKind = {
    .name = "workshop",
    .min_area_m2 = 100.0f,
    .max_area_m2 = 1500.0f,
    .ceiling = {3.0f, 5.2f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.35},
    .lay = Lay,
    .furnish = Furnish,
    .pits = {kWorkshop, 0.35, true}};

}  // namespace

const BuildingKind& Workshop() {
  return kKind;
}

}  // namespace bulletnav::sim::building
