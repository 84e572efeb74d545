// SPDX-License-Identifier: MIT
// Shops: book shops, clothes shops, grocers, hardware; rooms for stock and staff behind them.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/building/kind.h"
#include "sim/house/building/rooms.h"
#include "sim/house/building/stairwell.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;

constexpr std::array kBack = {
    Cell{kStockRoom, 3.0f, 7.0f, 1.0, 1, 4},    Cell{kRestroom, 2.4f, 3.4f, 0.0, 1, 1},
    Cell{kOffice, 2.8f, 4.2f, 0.5, 0, 2},       Cell{kFittingRoom, 3.2f, 5.5f, 0.5, 0, 2},
    Cell{kBreakRoom, 3.2f, 5.0f, 0.3, 0, 1},    Cell{kStairwell, 3.2f, 5.0f, 0.5, 0, 1},
    Cell{kTechnicalRoom, 2.2f, 3.2f, 0.3, 0, 1}};
/// Small shops beside each other on a hall: an arcade.
constexpr std::array kUnits = {Cell{kShopFloor, 5.0f, 10.0f, 1.0, 1, 99, OpeningKind::kArch},
                               Cell{kStairwell, 3.2f, 4.5f, 0.1, 0, 1},
                               Cell{kStockRoom, 3.0f, 4.5f, 0.2, 0, 2}};

Block OneShop(float area, Rng* rng) {
  Block block;
  block.bands.push_back(
      {.depth = Draw(rng, 3.2, 5.0), .cells = kBack, .share = Draw(rng, 0.6, 1.0)});
  const float most = std::clamp(0.85f * std::sqrt(area), 7.0f, 22.0f);
  block.bands.push_back(
      {.depth = Draw(rng, 0.65 * static_cast<double>(most), static_cast<double>(most)),
       .hall = kShopFloor});
  return block;
}

Block Arcade(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 6.0, 9.0), .cells = kUnits});
  block.bands.push_back({.depth = Draw(rng, 3.0, 5.5), .hall = kLobby});
  block.bands.push_back({.depth = Draw(rng, 5.0, 8.0), .cells = kUnits});
  block.bands.push_back({.depth = Draw(rng, 1.5, 1.9), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 3.2, 4.2), .cells = kBack});
  return block;
}

void Lay(float area, Sketch* sketch, Rng* rng) {
  const bool is_arcade = area > 450.0f && rng->Chance(0.4);
  Block block = is_arcade ? Arcade(rng) : OneShop(area, rng);
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  block.length = std::max(8.0f, area / depth);
  if (!is_arcade && block.length > 14.0f && rng->Chance(0.5)) {
    block.tail = End{kShopFloor, Draw(rng, 0.25, 0.45) * block.length};
    block.length -= block.tail->length;
  }
  LayBlock(block, {{0, 0}, {1, 0}, {0, 1}}, -1, sketch, rng);
}

/// Counters side by side near one end, their customers towards the shop.
void Tills(Hall* hall, float u) {
  const auto count = std::clamp(static_cast<int>(hall->room().area() / 90.0f), 1, 6);
  const float pitch = 2.6f;
  const float first = 0.5f * hall->width() - 0.5f * pitch * static_cast<float>(count - 1);
  for (int i = 0; i < count; ++i) {
    const float v = first + pitch * static_cast<float>(i);
    const Placed* till = hall->Put("till_counter", u, v, Look::kRight, {.width = 1.7f});
    if (till == nullptr) till = hall->room().InTheOpen("till_counter", {.width = 1.4f});
    if (till != nullptr) hall->room().At(*till, "office_chair", {0.0f, -0.75f, 0.0f});
  }
}

/// What is left of the floor behind the tills.
Field Sales(const Hall& hall) {
  Field field = hall.Inner(1.1f);
  field.u0 = std::min(3.2f, 0.3f * hall.length());
  return field;
}

void FurnishBookShop(Hall* hall) {
  RoomFurnisher& room = hall->room();
  Field field = Sales(*hall);
  Field tables = field;
  tables.u1 = field.u0 + 0.3f * (field.u1 - field.u0);
  hall->Fill({.kind = "goods_table",
              .width = 1.5f,
              .pitch = Draw(hall->rng(), 2.2, 3.0),
              .gap = 1.1f,
              .share = 0.85f},
             tables);
  field.u0 = tables.u1 + 0.5f;
  hall->Fill({.kind = "book_gondola",
              .width = Draw(hall->rng(), 1.2, 2.0),
              .pitch = Draw(hall->rng(), 1.7, 2.4),
              .gap = room.Chance(0.7) ? 0.0f : 0.9f,
              .break_after = 5.0f,
              .share = 0.92f},
             field);
  static constexpr std::array<std::string_view, 4> kWalls = {"bookshelf", "bookshelf", "bookshelf",
                                                             "low_shelf"};
  hall->AlongWalls(kWalls, 4 + static_cast<int>(room.area() / 8.0f), 1.8f);
  room.NearWall("armchair");
}

void FurnishClothesShop(Hall* hall) {
  RoomFurnisher& room = hall->room();
  const Field field = Sales(*hall);
  const float middle = 0.5f * (field.v0 + field.v1);
  hall->Fill({.kind = "goods_table", .width = 1.4f, .pitch = 3.0f, .gap = 1.6f, .share = 0.7f},
             {field.u0, field.u1, middle - 1.2f, middle + 1.2f});
  hall->Fill({.kind = "garment_rack",
              .width = Draw(hall->rng(), 1.2, 1.8),
              .pitch = Draw(hall->rng(), 1.6, 2.3),
              .gap = Draw(hall->rng(), 0.6, 1.1),
              .share = 0.85f},
             field);
  for (int i = 0; i < 2 + static_cast<int>(room.area() / 30.0f); ++i) {
    hall->Scatter("mannequin", hall->Inner(0.8f));
  }
  static constexpr std::array<std::string_view, 5> kWalls = {
      "clothes_rail", "clothes_rail", "low_shelf", "standing_mirror", "display_cabinet"};
  hall->AlongWalls(kWalls, 4 + static_cast<int>(room.area() / 12.0f), 1.6f);
  if (room.Chance(0.6)) room.AgainstWall("changing_booth");
}

void FurnishGrocer(Hall* hall) {
  RoomFurnisher& room = hall->room();
  hall->Fill({.kind = "gondola",
              .width = Draw(hall->rng(), 1.3, 2.2),
              .pitch = Draw(hall->rng(), 1.9, 2.6),
              .break_after = Draw(hall->rng(), 6.0, 12.0),
              .share = 0.96f},
             Sales(*hall));
  for (int i = 0; i < 2 + static_cast<int>(room.area() / 40.0f); ++i) {
    room.AgainstWall("shop_cooler", {.width = 2.4f, .min_width = 1.2f, .far_from_doors = true});
  }
  static constexpr std::array<std::string_view, 4> kWalls = {"pantry_shelf", "shop_cooler",
                                                             "box_stack", "vending_machine"};
  hall->AlongWalls(kWalls, 2 + static_cast<int>(room.area() / 25.0f), 1.6f);
  for (int i = 0; i < static_cast<int>(room.area() / 60.0f); ++i) {
    hall->Scatter("goods_table", hall->Inner(1.2f), {.width = 1.1f});
  }
}

void FurnishHardwareShop(Hall* hall) {
  RoomFurnisher& room = hall->room();
  hall->Fill({.kind = room.Chance(0.5) ? "store_rack" : "gondola",
              .width = Draw(hall->rng(), 1.4, 2.4),
              .height = std::min(room.space().ceiling() - 0.5f, Draw(hall->rng(), 1.7, 2.6)),
              .pitch = Draw(hall->rng(), 2.1, 3.0),
              .break_after = 7.2f,
              .share = 0.92f},
             Sales(*hall));
  static constexpr std::array<std::string_view, 4> kWalls = {"utility_shelf", "utility_shelf",
                                                             "box_stack", "display_cabinet"};
  hall->AlongWalls(kWalls, 3 + static_cast<int>(room.area() / 20.0f), 1.8f);
  for (int i = 0; i < 2; ++i) room.OnWall("tool_wall", 0.9f, {.width = 1.8f});
  for (int i = 0; i < static_cast<int>(room.area() / 50.0f); ++i) {
    hall->Scatter(room.Chance(0.5) ? "pallet_stack" : "goods_table", hall->Inner(1.2f));
  }
}

void FurnishShopFloor(RoomFurnisher* room) {
  Hall hall(room);
  if (room->area() > 110.0f && room->Chance(0.6)) hall.Columns(Draw(hall.rng(), 5.0, 8.0));
  Tills(&hall, Draw(hall.rng(), 1.6, 2.2));
  switch (room->rng().Below(4)) {
    case 0:
      FurnishBookShop(&hall);
      break;
    case 1:
      FurnishClothesShop(&hall);
      break;
    case 2:
      FurnishGrocer(&hall);
      break;
    default:
      FurnishHardwareShop(&hall);
      break;
  }
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 60.0f); ++i) {
    room->OnWall("shop_sign", 2.0f, {.width = 1.6f});
  }
  room->OnWall("poster");
  room->NearWall(room->Chance(0.5) ? "potted_plant" : "bin");
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void FurnishFittingRoom(RoomFurnisher* room) {
  room->SetAlike(true);
  const int booths = 2 + static_cast<int>(room->area() / 5.0f);
  for (int i = 0; i < booths; ++i) {
    room->AgainstWall("changing_booth", {.anchor = placing::Anchor::kEnd});
  }
  room->SetAlike(false);
  room->AgainstWall("standing_mirror");
  room->AgainstWall("clothes_rail");
  room->AgainstWall("bench", {.width = 1.4f, .min_width = 0.8f});
  room->OnWall("poster");
  FinishRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kShopFloor) return FurnishShopFloor(room);
  if (type == kFittingRoom) return FurnishFittingRoom(room);
  if (type == kStockRoom) return FurnishStockRoom(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room);
  if (type == kStairwell) return FurnishStairwell(room);
  if (type == kTechnicalRoom) return FurnishTechnicalRoom(room);
  FurnishPassage(room);
}

constexpr std::array kFloors = {Surface{"grey_large_tile"},
                                Surface{"vinyl_floor"},
                                Surface{"oak_planks"},
                                Surface{"terrazzo"},
                                Surface{"loop_carpet", {126, 118, 108}},
                                Surface{"concrete", {200, 198, 194}},
                                Surface{"beige_stone_tile"},
                                Surface{"checker_tile"}};
constexpr std::array kHard = {Surface{"grey_large_tile"}, Surface{"concrete"},
                              Surface{"vinyl_floor", {190, 192, 190}}};
constexpr std::array kSoft = {Surface{"loop_carpet", {110, 100, 104}}, Surface{"oak_planks"},
                              Surface{"grey_planks"}};
constexpr std::array kWalls = {Surface{"plaster_smooth"},
                               Surface{"plaster_smooth", {236, 228, 212}},
                               Surface{"plaster_smooth", {206, 214, 210}},
                               Surface{"plaster_smooth", {226, 214, 206}}, Surface{"white_brick"}};
constexpr std::array kAccents = {Surface{"plaster_smooth", {176, 60, 54}},
                                 Surface{"plaster_smooth", {54, 86, 96}},
                                 Surface{"plaster_smooth", {232, 186, 80}},
                                 Surface{"plaster_smooth", {108, 132, 92}},
                                 Surface{"plaster_smooth", {60, 58, 60}},
                                 Surface{"red_brick"},
                                 Surface{"oak"}};
constexpr std::array kCeilings = {Surface{"plaster_smooth"}, Surface{"ceiling_grid"},
                                  Surface{"ceiling_grid"}, Surface{"plaster_smooth", {70, 70, 72}}};
constexpr std::array kBooks = {StyleKind::kModern, StyleKind::kScandinavian,
                               StyleKind::kIndustrial};

constexpr BuildingKind kKind = {
    .name = "shop",
    .min_area_m2 = 100.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {2.6f, 4.4f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.45},
    .lay = Lay,
    .furnish = Furnish,
    .pits = {kShopFloor, 0.2, false}};

}  // namespace

const BuildingKind& Shop() {
  return kKind;
}

}  // namespace bulletnav::sim::building
