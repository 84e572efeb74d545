// SPDX-License-Identifier: MIT
// Offices: open plan, cells along corridors, meeting rooms, around a core where they are large.
#include <algorithm>
#include <array>

#include "sim/house/building/kind.h"
#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;
constexpr OpeningKind kArch = OpeningKind::kArch;

constexpr std::array kCells = {Cell{kOffice, 2.8f, 4.5f, 3.0}, Cell{kMeetingRoom, 4.0f, 7.0f, 0.6},
                               Cell{kOffice, 5.0f, 8.0f, 0.8}};
constexpr std::array kMixed = {Cell{kOpenOffice, 8.0f, 16.0f, 1.0, 1, 3, kArch},
                               Cell{kOffice, 2.8f, 4.5f, 1.5}, Cell{kMeetingRoom, 4.0f, 7.0f, 0.6}};
constexpr std::array kService = {
    Cell{kRestroom, 2.4f, 3.6f, 0.0, 1, 1}, Cell{kBreakRoom, 3.5f, 6.0f, 0.3, 1, 1},
    Cell{kTechnicalRoom, 2.0f, 3.0f, 0.4, 0, 1}, Cell{kMeetingRoom, 3.6f, 6.5f, 1.0, 1, 4},
    Cell{kOffice, 2.8f, 4.2f, 1.0}};
constexpr std::array kCore = {Cell{kRestroom, 2.6f, 4.0f, 0.0, 2, 2},
                              Cell{kBreakRoom, 4.0f, 7.0f, 0.3, 1, 2},
                              Cell{kCorridor, 1.6f, 2.2f, 0.2, 1, 2, kArch, true},
                              Cell{kStockRoom, 2.4f, 4.0f, 0.5, 0, 2},
                              Cell{kTechnicalRoom, 2.2f, 3.5f, 0.4, 0, 2},
                              Cell{kMeetingRoom, 4.0f, 7.0f, 1.0, 1, 4}};

/// One open hall with small rooms along it.
Block OpenPlan(float area, Rng* rng) {
  Block block;
  const bool has_two_rows = area > 350.0f;
  block.bands.push_back({.depth = Draw(rng, 3.2, 4.2), .cells = kService});
  block.bands.push_back({.depth = Draw(rng, 6.0, has_two_rows ? 14.0 : 9.0), .hall = kOpenOffice});
  if (has_two_rows)
    block.bands.push_back(
        {.depth = Draw(rng, 3.2, 4.5), .cells = kCells, .share = Draw(rng, 0.6, 1.0)});
  return block;
}

/// Cells on both sides of a corridor.
Block Spine(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 3.8, 5.2),
                         .cells = rng->Chance(0.5) ? std::span<const Cell>(kCells) : kMixed});
  block.bands.push_back({.depth = Draw(rng, 1.5, 2.1), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 3.6, 4.8),
                         .cells = kService,
                         .share = rng->Chance(0.4) ? Draw(rng, 0.6, 0.9) : 1.0f});
  return block;
}

/// Two corridors around a core.
Block Core(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 4.0, 6.5), .cells = kMixed});
  block.bands.push_back({.depth = Draw(rng, 1.6, 2.2), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 4.0, 5.5), .cells = kCore});
  block.bands.push_back(
      {.depth = Draw(rng, 1.6, 2.2), .hall = rng->Chance(0.3) ? kOpenOffice : kCorridor});
  if (block.bands.back().hall == kOpenOffice) {
    block.bands.back().depth = Draw(rng, 6.0, 10.0);
  } else {
    block.bands.push_back({.depth = Draw(rng, 4.0, 6.5),
                           .cells = rng->Chance(0.5) ? std::span<const Cell>(kCells) : kMixed});
  }
  return block;
}

void Lay(float area, Sketch* sketch, Rng* rng) {
  Block block;
  if (area > 500.0f && rng->Chance(0.6)) {
    block = Core(rng);
  } else if (rng->Chance(0.5)) {
    block = OpenPlan(area, rng);
  } else {
    block = Spine(rng);
  }
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  block.length = std::max(8.0f, area / depth);
  const bool is_long = block.length > 40.0f;
  if (is_long || (block.length > 12.0f && rng->Chance(0.7))) {
    block.head = End{kReception, std::min(Draw(rng, 4.0, 7.0), 0.4f * block.length)};
    block.length -= block.head->length;
  }
  LayBent(block, rng->Chance(0.3) ? 25.0f : 40.0f, sketch, rng);
}

/// Islands of desks, or rows of cubicles, and a few things along the walls.
void FurnishOpenOffice(RoomFurnisher* room) {
  Hall hall(room);
  if (room->area() > 90.0f && room->Chance(0.7)) hall.Columns(Draw(hall.rng(), 5.5, 8.0));
  room->SetAlike(room->Chance(0.5));
  if (room->Chance(0.4)) {
    hall.Fill({.kind = "cubicle",
               .width = Draw(hall.rng(), 1.8, 2.2),
               .pitch = 3.1f,
               .depth = 1.8f,
               .break_after = 7.0f,
               .share = 0.92f},
              hall.Inner(0.9f));
  } else {
    hall.Fill({.kind = "desk_pair",
               .width = 1.6f,
               .pitch = Draw(hall.rng(), 3.3, 4.2),
               .break_after = 4.8f,
               .share = 0.92f},
              hall.Inner(1.0f));
  }
  room->SetAlike(false);
  static constexpr std::array<std::string_view, 5> kWalls = {"credenza", "copier", "filing_cabinet",
                                                             "bookshelf", "locker_row"};
  hall.AlongWalls(kWalls, 2 + static_cast<int>(room->area() / 25.0f), 1.8f);
  if (room->area() > 60.0f && room->Chance(0.5)) {
    for (int i = 0; i < 3; ++i) {
      hall.Scatter("glass_screen", hall.Inner(1.5f),
                   {.width = 2.4f, .height = room->space().ceiling()});
    }
  }
  for (int i = 0; i < 1 + static_cast<int>(room->area() / 30.0f); ++i) {
    room->NearWall(room->Chance(0.6) ? "potted_plant" : "tall_plant");
  }
  room->NearWall("water_cooler");
  room->OnWall("whiteboard", 0.9f);
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kOpenOffice) return FurnishOpenOffice(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kMeetingRoom) return FurnishMeetingRoom(room);
  if (type == kReception) return FurnishLobby(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room, true);
  if (type == kStockRoom) return FurnishStockRoom(room);
  if (type == kTechnicalRoom) return FurnishTechnicalRoom(room);
  FurnishPassage(room);
}

constexpr std::array kFloors = {Surface{"loop_carpet", {120, 124, 130}},
                                Surface{"loop_carpet", {96, 112, 128}},
                                Surface{"grey_large_tile"},
                                Surface{"concrete"},
                                Surface{"oak_planks", {232, 220, 203}},
                                Surface{"loop_carpet", {150, 140, 128}},
                                Surface{"terrazzo"}};
constexpr std::array kHard = {Surface{"grey_large_tile"}, Surface{"slate_tile"},
                              Surface{"concrete"}};
constexpr std::array kSoft = {Surface{"loop_carpet", {104, 110, 120}},
                              Surface{"plush_carpet", {140, 138, 132}}, Surface{"oak_planks"}};
constexpr std::array kWalls = {
    Surface{"plaster_smooth"}, Surface{"plaster_smooth", {232, 230, 224}},
    Surface{"plaster_smooth", {214, 220, 224}}, Surface{"plaster_smooth", {200, 202, 200}}};
constexpr std::array kAccents = {Surface{"plaster_smooth", {70, 110, 150}},
                                 Surface{"plaster_smooth", {206, 120, 60}},
                                 Surface{"plaster_smooth", {96, 140, 104}},
                                 Surface{"plaster_smooth", {90, 92, 100}},
                                 Surface{"oak"},
                                 Surface{"concrete"}};
constexpr std::array kCeilings = {Surface{"plaster_smooth"}, Surface{"ceiling_grid"},
                                  Surface{"ceiling_grid"}, Surface{"concrete"}};
constexpr std::array kBooks = {StyleKind::kModern, StyleKind::kScandinavian,
                               StyleKind::kIndustrial};

constexpr BuildingKind kKind = {
    .name = "office",
    .min_area_m2 = 100.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {2.5f, 3.4f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.3},
    .lay = Lay,
    .furnish = Furnish};

}  // namespace

const BuildingKind& Office() {
  return kKind;
}

}  // namespace bulletnav::sim::building
