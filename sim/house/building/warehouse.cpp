// SPDX-License-Identifier: MIT
// Warehouses and workshops: high halls with racks or machines, offices along one side.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/building/kind.h"
#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;

constexpr std::array kSide = {
    Cell{kRestroom, 2.4f, 3.5f, 0.0, 1, 1}, Cell{kOffice, 3.0f, 5.0f, 1.0, 1, 4},
    Cell{kBreakRoom, 3.5f, 6.0f, 0.5, 1, 1}, Cell{kStockRoom, 3.0f, 6.0f, 1.0},
    Cell{kTechnicalRoom, 2.2f, 3.5f, 0.5, 0, 2}};

void Lay(float area, Sketch* sketch, Rng* rng) {
  const RoomType main = rng->Chance(0.65) ? kWarehouse : kWorkshop;
  const RoomType other = main == kWarehouse ? kWorkshop : kWarehouse;
  Block block;
  block.bands.push_back(
      {.depth = Draw(rng, 3.2, 4.5), .cells = kSide, .share = Draw(rng, 0.5, 1.0)});
  const float most = std::clamp(0.9f * std::sqrt(area), 8.0f, 24.0f);
  block.bands.push_back(
      {.depth = Draw(rng, 0.7 * static_cast<double>(most), static_cast<double>(most)),
       .hall = main});
  const float depth = block.bands[0].depth + block.bands[1].depth;
  float length = area / depth;
  if (length > 16.0f && rng->Chance(0.6)) {
    block.tail = End{other, Draw(rng, 0.25, 0.5) * length};
    length -= block.tail->length;
  }
  block.length = std::max(9.0f, length);
  LayBlock(block, {{0, 0}, {1, 0}, {0, 1}}, -1, sketch, rng);
}

void FurnishWarehouse(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.width() > 12.0f && room->Chance(0.6)) hall.Columns(Draw(hall.rng(), 6.0, 9.0));
  const float high = std::min(0.85f * room->space().ceiling(), Draw(hall.rng(), 2.2, 5.0));
  // Goods come in and go out at one end.
  Field racks = hall.Inner(1.0f);
  const float yard = std::max(2.0f, Draw(hall.rng(), 0.1, 0.35) * hall.length());
  racks.u1 -= yard;
  hall.Fill({.kind = room->Chance(0.75) ? "pallet_rack" : "store_rack",
             .width = 2.7f,
             .height = high,
             .pitch = Draw(hall.rng(), 2.7, 4.2),
             .break_after = 10.8f},
            racks);
  for (int i = 0; i < 2 + static_cast<int>(0.05f * room->area()); ++i) {
    hall.Scatter("pallet_stack",
                 {racks.u1 + 0.8f, hall.length() - 0.9f, 1.0f, hall.width() - 1.0f});
  }
  hall.Scatter("forklift", {racks.u1 + 1.0f, hall.length() - 1.5f, 1.5f, hall.width() - 1.5f});
  static constexpr std::array<std::string_view, 4> kWalls = {"workbench", "utility_shelf",
                                                             "locker_row", "box_stack"};
  hall.AlongWalls(kWalls, 2 + static_cast<int>(room->area() / 60.0f), 2.0f);
  room->OnWall("exit_sign", 2.3f);
  FinishRoom(room);
}

void FurnishWorkshop(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.width() > 10.0f && room->Chance(0.6)) hall.Columns(Draw(hall.rng(), 5.5, 8.0));
  hall.Fill({.kind = "machine",
             .width = 2.0f,
             .pitch = Draw(hall.rng(), 3.0, 4.5),
             .gap = Draw(hall.rng(), 1.0, 2.0),
             .share = 0.8f},
            hall.Inner(1.6f));
  static constexpr std::array<std::string_view, 4> kWalls = {"workbench", "workbench",
                                                             "utility_shelf", "locker_row"};
  hall.AlongWalls(kWalls, 3 + static_cast<int>(room->area() / 20.0f), 2.4f);
  for (int i = 0; i < 3; ++i) room->NearWall(room->Chance(0.5) ? "drums" : "pallet_stack");
  room->OnWall("exit_sign", 2.3f);
  FinishRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kWarehouse) return FurnishWarehouse(room);
  if (type == kWorkshop) return FurnishWorkshop(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room, true);
  if (type == kStockRoom) return FurnishStockRoom(room);
  FurnishTechnicalRoom(room);
}

constexpr std::array kFloors = {Surface{"concrete"}, Surface{"concrete", {190, 190, 184}},
                                Surface{"concrete", {150, 160, 168}},
                                Surface{"concrete", {176, 196, 182}}};
constexpr std::array kHard = {Surface{"concrete"}, Surface{"grey_large_tile"}};
constexpr std::array kSoft = {Surface{"loop_carpet", {110, 112, 116}}, Surface{"grey_large_tile"}};
constexpr std::array kWalls = {Surface{"plaster_rough"}, Surface{"plaster_rough", {206, 208, 206}},
                               Surface{"concrete", {235, 235, 230}},
                               Surface{"corrugated_metal", {214, 218, 222}},
                               Surface{"corrugated_metal", {170, 184, 196}}};
constexpr std::array kAccents = {Surface{"red_brick"}, Surface{"corrugated_metal", {120, 140, 160}},
                                 Surface{"plaster_rough", {226, 190, 70}}};
constexpr std::array kCeilings = {Surface{"corrugated_metal", {200, 202, 204}}, Surface{"concrete"},
                                  Surface{"corrugated_metal", {120, 122, 126}}};
constexpr std::array kBooks = {StyleKind::kIndustrial, StyleKind::kModern};

constexpr BuildingKind kKind = {
    .name = "warehouse",
    .min_area_m2 = 120.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {3.4f, 6.5f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.25},
    .lay = Lay,
    .furnish = Furnish};

}  // namespace

const BuildingKind& Warehouse() {
  return kKind;
}

}  // namespace bulletnav::sim::building
