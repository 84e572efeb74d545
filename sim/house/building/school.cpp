// SPDX-License-Identifier: MIT
// Schools and institutes: classrooms or laboratories along wide corridors, a hall at the end.
#include <algorithm>
#include <array>

#include "sim/house/building/kind.h"
#include "sim/house/building/patterns.h"
#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;
constexpr OpeningKind kArch = OpeningKind::kArch;

constexpr std::array kClasses = {Cell{kClassroom, 7.0f, 10.0f, 3.0, 1},
                                 Cell{kLaboratory, 7.0f, 11.0f, 1.6, 0, 3},
                                 Cell{kStockRoom, 2.4f, 3.5f, 0.3, 0, 1}};
constexpr std::array kResearch = {
    Cell{kLaboratory, 5.5f, 11.0f, 3.0, 1}, Cell{kOffice, 3.0f, 4.5f, 1.5},
    Cell{kMeetingRoom, 4.5f, 7.0f, 0.4, 0, 2}, Cell{kStockRoom, 2.4f, 4.0f, 0.4, 0, 2}};
constexpr std::array kSide = {
    Cell{kRestroom, 3.0f, 4.5f, 0.0, 1, 2}, Cell{kBreakRoom, 4.5f, 7.0f, 0.4, 1, 1},
    Cell{kOffice, 3.0f, 4.5f, 0.8, 0, 4},   Cell{kStockRoom, 2.4f, 4.0f, 0.5, 0, 2},
    Cell{kClassroom, 6.5f, 9.0f, 1.5},      Cell{kTechnicalRoom, 2.2f, 3.2f, 0.3, 0, 1}};
constexpr std::array kSmall = {
    Cell{kClassroom, 6.0f, 8.5f, 2.0, 1}, Cell{kRestroom, 2.4f, 3.0f, 0.0, 1, 1},
    Cell{kOffice, 2.8f, 4.0f, 0.6, 0, 2}, Cell{kLaboratory, 5.5f, 8.0f, 0.6, 0, 1}};
constexpr std::array kCore = {Cell{kRestroom, 3.0f, 4.5f, 0.0, 2, 2},
                              Cell{kBreakRoom, 4.5f, 7.0f, 0.3, 1, 1},
                              Cell{kCorridor, 2.0f, 2.8f, 0.2, 1, 2, kArch, true},
                              Cell{kLaboratory, 7.0f, 10.0f, 1.0, 0, 2},
                              Cell{kCanteen, 7.0f, 11.0f, 0.6, 0, 1, kArch},
                              Cell{kStockRoom, 2.6f, 4.5f, 0.6, 0, 3}};

/// Rooms on one side of a corridor, windows on its other side.
Block Gallery(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 5.6, 6.8), .cells = kSmall});
  block.bands.push_back({.depth = Draw(rng, 1.8, 2.4), .hall = kCorridor});
  return block;
}

Block Spine(std::span<const Cell> rooms, Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 6.4, 8.0), .cells = rooms});
  block.bands.push_back({.depth = Draw(rng, 2.2, 3.4), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 5.0, 7.0),
                         .cells = kSide,
                         .share = rng->Chance(0.4) ? Draw(rng, 0.6, 0.9) : 1.0f});
  return block;
}

Block Core(std::span<const Cell> rooms, Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 6.4, 8.0), .cells = rooms});
  block.bands.push_back({.depth = Draw(rng, 2.0, 2.8), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 5.0, 7.5), .cells = kCore});
  block.bands.push_back({.depth = Draw(rng, 2.0, 2.8), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 6.0, 7.5), .cells = kSide});
  return block;
}

void Lay(float area, Sketch* sketch, Rng* rng) {
  const std::span<const Cell> rooms =
      rng->Chance(0.62) ? std::span<const Cell>(kClasses) : kResearch;
  const bool has_core = area > 900.0f && rng->Chance(0.5);
  const bool is_small = area < 260.0f;
  Block block = is_small ? Gallery(rng) : (has_core ? Core(rooms, rng) : Spine(rooms, rng));
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  block.length = std::max(10.0f, area / depth);
  if (!is_small || rng->Chance(0.4)) {
    block.head = End{kLobby, std::min(Draw(rng, 4.0, 9.0), 0.3f * block.length)};
    block.length -= block.head->length;
  }
  if (area > 420.0f && rng->Chance(0.75)) {
    block.tail = End{kAssemblyHall, std::min(Draw(rng, 7.0, 16.0), 0.35f * block.length),
                     OpeningKind::kDoor};
    block.length -= block.tail->length;
  }
  block.length = std::max(9.0f, block.length);
  constexpr float kNever = 1000.0f;
  LayBent(block, has_core ? kNever : Draw(rng, 30.0, 60.0), sketch, rng);
}

/// Hangs a board; the way to look at it.
Look HangBoard(Hall* hall) {
  RoomFurnisher& room = hall->room();
  const std::string_view kind = room.Chance(0.6) ? "blackboard" : "whiteboard";
  for (const float width : {3.6f, 2.8f, 2.0f, 1.4f}) {
    const Placed* board = room.OnWall(kind, 0.85f, {.width = width});
    if (board != nullptr) return Opposite(LookOf(*hall, *board));
  }
  return Look::kRight;
}

/// Before the board, looking at the pupils.
void PlaceTeacher(Hall* hall, Look look) {
  const bool along = look == Look::kRight || look == Look::kLeft;
  const float share = Draw(hall->rng(), 0.2, 0.8);
  const float deep = along ? hall->length() : hall->width();
  const float away = look == Look::kUp || look == Look::kRight ? deep - 1.5f : 1.5f;
  const float aside = share * (along ? hall->width() : hall->length());
  const placing::Wish wish{.width = 1.5f};
  const Placed* desk = along ? hall->Put("desk", away, aside, Opposite(look), wish)
                             : hall->Put("desk", aside, away, Opposite(look), wish);
  if (desk != nullptr) hall->room().At(*desk, "office_chair", {0.0f, -0.4f, 0.0f});
}

void FurnishClassroom(RoomFurnisher* room) {
  Hall hall(room);
  const Look look = HangBoard(&hall);
  PlaceTeacher(&hall, look);
  room->SetAlike(room->Chance(0.5));
  const bool single = room->Chance(0.25);
  Seat(&hall, look,
       {.kind = "school_desk",
        .width = single ? 0.75f : 1.3f,
        .pitch = Draw(hall.rng(), 1.35, 1.7),
        .first = 2.7f,
        .side = 0.55f,
        .gap = Draw(hall.rng(), 0.45, 0.8)});
  room->SetAlike(false);
  static constexpr std::array<std::string_view, 4> kWalls = {"low_shelf", "credenza", "bookshelf",
                                                             "locker_row"};
  hall.AlongWalls(kWalls, 2, 1.8f);
  if (room->Chance(0.5)) room->OnWall("projector_screen", 1.2f);
  for (int i = 0; i < 2; ++i) room->OnWall(room->Chance(0.5) ? "poster" : "pin_board");
  room->OnWall("wall_clock", 2.0f);
  room->NearWall("bin");
  if (room->Chance(0.3)) room->NearWall("potted_plant");
  FinishRoom(room);
}

void FurnishLaboratory(RoomFurnisher* room) {
  Hall hall(room);
  const bool is_glazed = hall.length() > 9.0f && room->Chance(0.4);
  if (is_glazed) GlazedWall(&hall, 0.3f * hall.length());
  if (room->Chance(0.6)) room->AgainstWall("fume_hood", {.width = 1.6f, .min_width = 1.2f});
  const int benches = 1 + static_cast<int>(room->area() / 25.0f);
  room->SetAlike(room->Chance(0.5));
  hall.Fill({.kind = "lab_bench",
             .width = Draw(hall.rng(), 1.8, 2.8),
             .pitch = Draw(hall.rng(), 2.6, 3.2),
             .break_after = 5.0f},
            hall.Inner(0.9f));
  room->SetAlike(false);
  for (int i = 0; i < benches; ++i) {
    room->AgainstWall("lab_wall_bench", {.width = 3.2f, .min_width = 1.4f});
  }
  static constexpr std::array<std::string_view, 3> kWalls = {"medicine_cabinet", "refrigerator",
                                                             "utility_shelf"};
  hall.AlongWalls(kWalls, 2, 1.4f);
  room->OnWall("whiteboard", 0.0f, {.width = 1.8f});
  room->OnWall("poster");
  room->NearWall("bin");
  FinishRoom(room);
}

/// For sports: everything along the walls.
void FurnishGym(Hall* hall) {
  RoomFurnisher& room = hall->room();
  if (room.space().ceiling() > 3.2f) {
    room.SetAlike(true);
    for (int i = 0; i < 2; ++i) room.OnWall("basketball_hoop", room.space().ceiling() - 1.1f);
    room.SetAlike(false);
  }
  for (int i = 0; i < 3; ++i) room.AgainstWall("wall_bars", {.width = 2.7f, .min_width = 0.9f});
  for (int i = 0; i < 2; ++i) room.AgainstWall("bench");
  for (int i = 0; i < room.rng().Between(2, 5); ++i)
    hall->Scatter("vaulting_box", hall->Inner(1.5f));
  for (int i = 0; i < 2; ++i) room.NearWall("gym_mats");
  for (int i = 0; i < 4; ++i) room.NearWall("ball");
}

/// Rows of chairs before a screen.
void FurnishAuditorium(Hall* hall) {
  RoomFurnisher& room = hall->room();
  const Placed* screen = room.OnWall("projector_screen", 1.0f, {.width = 3.0f});
  const Look look = screen != nullptr ? Opposite(LookOf(*hall, *screen)) : Look::kRight;
  const bool along = look == Look::kRight || look == Look::kLeft;
  const float deep = along ? hall->length() : hall->width();
  const float away = look == Look::kUp || look == Look::kRight ? deep - 1.4f : 1.4f;
  const float aside = 0.3f * (along ? hall->width() : hall->length());
  along ? hall->Put("lectern", away, aside, Opposite(look))
        : hall->Put("lectern", aside, away, Opposite(look));
  room.SetAlike(true);
  Seat(hall, look,
       {.kind = "chair_row",
        .width = 2.5f,
        .pitch = Draw(hall->rng(), 1.0, 1.25),
        .first = 3.2f,
        .last = 1.4f,
        .side = 1.1f,
        .gap = 0.02f,
        .aisle = 1.3f,
        .share = 1.0});
  room.SetAlike(false);
  room.AgainstWall("piano");
}

void FurnishAssemblyHall(RoomFurnisher* room) {
  Hall hall(room);
  if (hall.width() > 12.0f && room->Chance(0.5)) hall.Columns(Draw(hall.rng(), 5.5, 8.0));
  room->Chance(0.5) ? FurnishGym(&hall) : FurnishAuditorium(&hall);
  for (int i = 0; i < 2; ++i) room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

/// Lockers and coats along both walls.
void FurnishSchoolCorridor(RoomFurnisher* room) {
  const bool has_lockers = room->Chance(0.6);
  room->SetAlike(true);
  const int rows = static_cast<int>(room->area() / 9.0f);
  for (int i = 0; i < rows; ++i) {
    if (has_lockers) {
      room->AgainstWall("locker_row", {.width = 2.6f, .min_width = 1.4f});
    } else {
      room->OnWall("coat_hooks", 0.55f, {.width = 1.8f});
      if (i % 2 == 0) room->AgainstWall("bench");
    }
  }
  room->SetAlike(false);
  FurnishPassage(room);
}

void FurnishSchoolLobby(RoomFurnisher* room) {
  if (room->Chance(0.6)) room->AgainstWall("display_cabinet");
  if (room->Chance(0.6)) room->AgainstWall("display_cabinet");
  for (int i = 0; i < 3; ++i) room->OnWall(room->Chance(0.5) ? "pin_board" : "poster");
  FurnishLobby(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kClassroom) return FurnishClassroom(room);
  if (type == kLaboratory) return FurnishLaboratory(room);
  if (type == kAssemblyHall) return FurnishAssemblyHall(room);
  if (type == kCanteen) return FurnishCanteen(room);
  if (type == kLobby) return FurnishSchoolLobby(room);
  if (type == kCorridor) return FurnishSchoolCorridor(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kMeetingRoom) return FurnishMeetingRoom(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room);
  if (type == kStockRoom) return FurnishStockRoom(room);
  FurnishTechnicalRoom(room);
}

constexpr std::array kFloors = {Surface{"vinyl_floor"},
                                Surface{"vinyl_floor", {176, 196, 206}},
                                Surface{"vinyl_floor", {206, 190, 150}},
                                Surface{"terrazzo"},
                                Surface{"oak_herringbone"},
                                Surface{"concrete"},
                                Surface{"grey_large_tile"}};
constexpr std::array kHard = {Surface{"terrazzo"}, Surface{"grey_large_tile"},
                              Surface{"vinyl_floor", {170, 176, 180}}};
constexpr std::array kSoft = {Surface{"loop_carpet", {104, 114, 126}}, Surface{"oak_planks"},
                              Surface{"vinyl_floor"}};
constexpr std::array kWalls = {Surface{"plaster_smooth"},
                               Surface{"plaster_smooth", {240, 234, 216}},
                               Surface{"plaster_rough", {226, 228, 222}}, Surface{"white_brick"},
                               Surface{"plaster_smooth", {214, 224, 216}}};
constexpr std::array kAccents = {Surface{"plaster_smooth", {226, 180, 70}},
                                 Surface{"plaster_smooth", {90, 150, 190}},
                                 Surface{"plaster_smooth", {150, 190, 110}},
                                 Surface{"plaster_smooth", {206, 96, 72}},
                                 Surface{"red_brick"},
                                 Surface{"oak"}};
constexpr std::array kCeilings = {Surface{"ceiling_grid"}, Surface{"plaster_smooth"},
                                  Surface{"concrete"}};
constexpr std::array kBooks = {StyleKind::kScandinavian, StyleKind::kModern,
                               StyleKind::kIndustrial};

constexpr BuildingKind kKind = {
    .name = "school",
    .min_area_m2 = 120.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {2.7f, 3.7f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.35},
    .lay = Lay,
    .furnish = Furnish};

}  // namespace

const BuildingKind& School() {
  return kKind;
}

}  // namespace bulletnav::sim::building
