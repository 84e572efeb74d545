// SPDX-License-Identifier: MIT
// Hotels: rooms that look alike along long corridors, each with its bath; a lobby, a breakfast
// room.
#include <algorithm>
#include <array>

#include "sim/house/building/kind.h"
#include "sim/house/building/patterns.h"
#include "sim/house/building/rooms.h"
#include "sim/house/placing/programs.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;
constexpr OpeningKind kArch = OpeningKind::kArch;

constexpr std::array kCore = {
    Cell{kRestroom, 2.6f, 4.0f, 0.0, 1, 1},  Cell{kCorridor, 1.8f, 2.6f, 0.2, 1, 3, kArch, true},
    Cell{kStockRoom, 2.6f, 5.0f, 0.8, 1, 3}, Cell{kMeetingRoom, 4.5f, 8.0f, 0.8, 0, 2},
    Cell{kOffice, 3.0f, 4.5f, 0.5, 0, 2},    Cell{kTechnicalRoom, 2.2f, 3.5f, 0.4, 0, 2}};

/// The rooms of one house: all of one width, their baths of one size.
struct Rooms {
  float depth = 6.0f;
  std::array<Cell, 3> cells;  // with a linen room now and then, and a breakfast room if asked for
};

Rooms DrawRooms(bool has_breakfast, Rng* rng) {
  Rooms rooms;
  rooms.depth = Draw(rng, 5.4, 7.2);
  const float width = Draw(rng, 3.5, 4.4);
  const float bath = std::min(Draw(rng, 1.8, 2.2), width - 1.6f);
  const Alcove alcove{kBathroom, bath, Draw(rng, 2.0, 2.5)};
  const int breakfast = has_breakfast ? 1 : 0;
  rooms.cells = {
      Cell{kHotelRoom, width, width + 0.06f, 8.0, 1, 99, OpeningKind::kDoor, false, alcove},
      Cell{kStockRoom, 2.2f, 3.4f, 0.4, 0, 1},
      Cell{kCanteen, 4.5f, 7.5f, 0.0, breakfast, breakfast, kArch}};
  return rooms;
}

/// The bands; `rooms` must outlive them.
Block DrawBlock(float area, const Rooms& first, const Rooms& second, Rng* rng) {
  Block block;
  block.bands.push_back({.depth = first.depth, .cells = first.cells});
  block.bands.push_back({.depth = Draw(rng, 1.5, 2.1), .hall = kCorridor});
  if (area < 300.0f) return block;
  if (area > 900.0f && rng->Chance(0.5)) {
    block.bands.push_back({.depth = Draw(rng, 3.5, 5.5), .cells = kCore});
    block.bands.push_back({.depth = block.bands[1].depth, .hall = kCorridor});
  }
  block.bands.push_back({.depth = second.depth,
                         .cells = second.cells,
                         .share = rng->Chance(0.3) ? Draw(rng, 0.6, 0.9) : 1.0f});
  return block;
}

void Lay(float area, Sketch* sketch, Rng* rng) {
  const bool has_tail = area > 420.0f && rng->Chance(0.6);
  const Rooms first = DrawRooms(!has_tail && area > 200.0f, rng);
  Rooms second = first;
  second.cells[2].least = 0;
  second.cells[2].most = 0;
  Block block = DrawBlock(area, first, second, rng);
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  block.length = std::max(10.0f, area / depth);
  block.head = End{kLobby, std::min(Draw(rng, 4.0, 9.0), 0.35f * block.length)};
  block.length -= block.head->length;
  if (has_tail) {
    block.tail = End{kCanteen, std::min(Draw(rng, 5.0, 9.0), 0.3f * block.length)};
    block.length -= block.tail->length;
  }
  const bool has_core = block.bands.size() > 3;
  constexpr float kNever = 1000.0f;
  LayBent(block, has_core ? kNever : Draw(rng, 25.0, 70.0), sketch, rng);
}

/// What the rooms of one house have in common besides their pieces' looks.
struct GuestRoom {
  bool is_twin = false;
  bool has_mirror = false;  // over the desk, else a screen
  bool has_lamp = false;
  bool has_chair = false;
};

GuestRoom DrawGuestRoom(RoomFurnisher* room) {
  GuestRoom guest;
  guest.is_twin = room->Chance(0.3);
  guest.has_mirror = room->Chance(0.5);
  guest.has_lamp = room->Chance(0.5);
  guest.has_chair = room->Chance(0.7);
  return guest;
}

void PlaceGuestBed(const GuestRoom& guest, RoomFurnisher* room) {
  const placing::Wish wish{.anchor = placing::Anchor::kCentre, .far_from_doors = true};
  const Placed* bed = room->AgainstWall(guest.is_twin ? "single_bed" : "double_bed", wish);
  if (bed == nullptr) bed = room->AgainstWall("single_bed", {.squeeze = true});
  if (bed == nullptr) return;
  for (const bool left : {true, false}) {
    const Placed* stand = room->Beside(*bed, "nightstand", left);
    if (stand == nullptr) continue;
    room->OnTop(*stand, "table_lamp");
    if (guest.is_twin && left) room->Beside(*stand, "single_bed", true);
  }
  room->Over(*bed, "painting", 0.35f);
}

/// The same in every room of the house, as far as its plan allows.
void FurnishGuestRoom(RoomFurnisher* room) {
  room->DrawAsInOtherRooms();
  const GuestRoom guest = DrawGuestRoom(room);
  room->SetAlike(true);
  PlaceGuestBed(guest, room);
  const Placed* desk =
      room->AgainstWallWithSeat("desk", "office_chair", {.width = 1.4f, .min_width = 1.0f});
  if (desk != nullptr) room->Over(*desk, guest.has_mirror ? "mirror" : "wall_tv", 0.4f);
  room->AgainstWall("wardrobe",
                    {.width = 1.2f, .min_width = 0.8f, .anchor = placing::Anchor::kEnd});
  room->AgainstWall("minibar");
  room->AgainstWall("luggage_rack");
  if (guest.has_chair) room->AgainstWall("armchair");
  if (guest.has_lamp) room->NearWall("floor_lamp");
  if (guest.has_mirror) room->OnWall("wall_tv", 1.1f);
  room->NearWall("bin");
  room->DressWindows(true);
  room->Light("ceiling_lamp");
  room->OnWall("painting");
  if (room->Chance(0.5)) room->NearWall("suitcase");  // guests differ
}

void FurnishGuestBath(RoomFurnisher* room) {
  room->DrawAsInOtherRooms();
  FurnishWetCell(room);
}

void FurnishHotelCorridor(RoomFurnisher* room) {
  room->SetAlike(true);
  for (const PlanPoint& mouth : room->space().mouths()) {
    room->OnWall("room_sign", 1.5f, {.beside = &mouth});
  }
  for (int i = 0; i < static_cast<int>(room->area() / 9.0f); ++i) room->OnWall("wall_lamp", 1.7f);
  const PlanPoint middle = room->space().main_floor().center();
  const Eigen::Vector2f floor = room->space().main_floor().sizes();
  if (room->Chance(0.4)) room->Rug("runner_rug", middle, 3.0f, floor.y() > floor.x());
  room->SetAlike(false);
  if (room->area() > 12.0f) room->AgainstWall("lift_doors");
  static constexpr std::array<std::string_view, 3> kLow = {"console_table", "bench", "linen_cart"};
  for (int i = 0; i < static_cast<int>(room->area() / 25.0f); ++i) {
    const std::string_view kind = room->Pick(kLow);
    kind == "linen_cart" ? room->NearWall(kind) : room->AgainstWall(kind);
  }
  placing::HangPictures(room, static_cast<int>(room->area() / 12.0f));
  room->OnWall("exit_sign", 2.1f);
  if (room->Chance(0.5)) room->OnWall("fire_extinguisher", 0.8f);
  Hall hall(room);
  hall.Lights("panel_lamp", 3.2f);
}

void FurnishHotelLobby(RoomFurnisher* room) {
  room->SetAlike(true);
  const int lifts = room->area() > 60.0f ? 2 : 1;
  for (int i = 0; i < lifts; ++i) room->AgainstWall("lift_doors");
  room->SetAlike(false);
  room->NearWall("bell_cart");
  if (room->Chance(0.5)) room->NearWall("suitcase");
  FurnishLobby(room);
}

void FurnishLinenRoom(RoomFurnisher* room) {
  for (int i = 0; i < 2; ++i) room->NearWall("linen_cart");
  FurnishStockRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kHotelRoom) return FurnishGuestRoom(room);
  if (type == kBathroom) return FurnishGuestBath(room);
  if (type == kLobby) return FurnishHotelLobby(room);
  if (type == kCanteen) return FurnishCanteen(room);
  if (type == kCorridor) return FurnishHotelCorridor(room);
  if (type == kStockRoom) return FurnishLinenRoom(room);
  if (type == kMeetingRoom) return FurnishMeetingRoom(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kRestroom) return FurnishRestroom(room);
  FurnishTechnicalRoom(room);
}

constexpr std::array kFloors = {Surface{"plush_carpet", {140, 46, 48}},
                                Surface{"loop_carpet", {72, 84, 108}},
                                Surface{"plush_carpet", {150, 132, 110}},
                                Surface{"loop_carpet", {110, 118, 104}},
                                Surface{"oak_herringbone"},
                                Surface{"beige_stone_tile"}};
constexpr std::array kHard = {Surface{"beige_stone_tile"}, Surface{"grey_large_tile"},
                              Surface{"concrete"}};
constexpr std::array kSoft = {Surface{"plush_carpet", {168, 150, 126}},
                              Surface{"plush_carpet", {104, 96, 98}},
                              Surface{"loop_carpet", {84, 100, 116}}, Surface{"walnut_planks"}};
constexpr std::array kWalls = {
    Surface{"plaster_smooth", {238, 230, 214}}, Surface{"plaster_smooth", {224, 220, 212}},
    Surface{"striped_wallpaper"}, Surface{"grasscloth_wallpaper"}, Surface{"plaster_smooth"}};
constexpr std::array kAccents = {Surface{"damask_wallpaper"}, Surface{"leaf_wallpaper"},
                                 Surface{"geometric_wallpaper"},
                                 Surface{"plaster_smooth", {70, 84, 96}}, Surface{"walnut"}};
constexpr std::array kCeilings = {Surface{"plaster_smooth"},
                                  Surface{"plaster_smooth", {240, 236, 226}}};
constexpr std::array kBooks = {StyleKind::kModern, StyleKind::kScandinavian,
                               StyleKind::kIndustrial};

constexpr BuildingKind kKind = {
    .name = "hotel",
    .min_area_m2 = 120.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {2.4f, 3.0f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.15},
    .lay = Lay,
    .furnish = Furnish};

}  // namespace

const BuildingKind& Hotel() {
  return kKind;
}

}  // namespace bulletnav::sim::building
