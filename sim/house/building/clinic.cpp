// SPDX-License-Identifier: MIT
// Clinics and hospitals: practices along a corridor, wards around nurses' stations.
#include <algorithm>
#include <array>

#include "sim/house/building/kind.h"
#include "sim/house/building/patterns.h"
#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

using enum RoomType;
constexpr OpeningKind kArch = OpeningKind::kArch;
constexpr OpeningKind kDoor = OpeningKind::kDoor;
constexpr float kQuarter = 0.5f * kHalfTurn;

constexpr std::array kExams = {
    Cell{kExamRoom, 3.0f, 4.2f, 3.0, 1}, Cell{kExamRoom, 4.6f, 6.5f, 0.8},
    Cell{kWaitingRoom, 4.0f, 7.0f, 0.5, 0, 2, kArch}, Cell{kOffice, 2.8f, 3.8f, 0.5, 0, 2},
    Cell{kLaboratory, 4.5f, 7.0f, 0.3, 0, 1}};
constexpr std::array kWards = {
    Cell{kWard, 3.8f, 4.8f, 2.0, 1, 99, kDoor, false, Alcove{kBathroom, 2.0f, 2.2f}},
    Cell{kWard, 5.6f, 8.5f, 1.5}, Cell{kWaitingRoom, 4.0f, 6.5f, 0.3, 0, 1, kArch},
    Cell{kExamRoom, 3.2f, 4.5f, 0.4, 0, 2}};
constexpr std::array kService = {
    Cell{kRestroom, 2.4f, 3.6f, 0.0, 1, 2}, Cell{kStockRoom, 2.2f, 3.6f, 0.4, 0, 2},
    Cell{kBreakRoom, 3.2f, 5.0f, 0.4, 0, 1}, Cell{kOffice, 2.8f, 4.0f, 0.6, 0, 3},
    Cell{kExamRoom, 3.0f, 4.4f, 1.2}};
constexpr std::array kCore = {Cell{kReception, 4.5f, 7.0f, 0.4, 1, 2, kArch},
                              Cell{kRestroom, 2.6f, 4.0f, 0.0, 2, 2},
                              Cell{kCorridor, 2.0f, 2.6f, 0.2, 1, 2, kArch, true},
                              Cell{kStockRoom, 2.6f, 4.5f, 0.6, 1, 3},
                              Cell{kTechnicalRoom, 2.2f, 3.5f, 0.3, 0, 1},
                              Cell{kExamRoom, 4.6f, 7.0f, 1.0, 1, 4},
                              Cell{kBreakRoom, 4.0f, 6.0f, 0.3, 0, 1}};

/// Consulting rooms on both sides of a corridor.
Block Practice(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 3.8, 5.2), .cells = kExams});
  block.bands.push_back({.depth = Draw(rng, 1.8, 2.4), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 3.4, 4.6),
                         .cells = kService,
                         .share = rng->Chance(0.4) ? Draw(rng, 0.6, 0.9) : 1.0f});
  return block;
}

/// Wards on one side, service on the other.
Block WardFloor(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 5.2, 6.4), .cells = kWards});
  block.bands.push_back({.depth = Draw(rng, 2.2, 3.0), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 4.6, 6.0),
                         .cells = rng->Chance(0.5) ? std::span<const Cell>(kWards) : kService});
  return block;
}

/// Two wide corridors around a core with nurses' stations.
Block Hospital(Rng* rng) {
  Block block;
  block.bands.push_back({.depth = Draw(rng, 5.2, 6.4), .cells = kWards});
  block.bands.push_back({.depth = Draw(rng, 2.2, 3.0), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 4.6, 6.5), .cells = kCore});
  block.bands.push_back({.depth = Draw(rng, 2.2, 3.0), .hall = kCorridor});
  block.bands.push_back({.depth = Draw(rng, 5.0, 6.2),
                         .cells = rng->Chance(0.5) ? std::span<const Cell>(kExams) : kWards});
  return block;
}

void Lay(float area, Sketch* sketch, Rng* rng) {
  const bool is_hospital = area > 650.0f && rng->Chance(0.65);
  const bool has_wards = area > 260.0f && rng->Chance(area > 500.0f ? 0.85 : 0.55);
  Block block = is_hospital ? Hospital(rng) : (has_wards ? WardFloor(rng) : Practice(rng));
  float depth = 0.0f;
  for (const Band& band : block.bands) depth += band.depth;
  block.length = std::max(8.0f, area / depth);
  block.head = End{kLobby, std::min(Draw(rng, 4.0, 8.0), 0.35f * block.length)};
  block.length = std::max(6.0f, block.length - block.head->length);
  constexpr float kNever = 1000.0f;
  LayBent(block, is_hospital ? kNever : Draw(rng, 25.0, 50.0), sketch, rng);
}

void FurnishWard(RoomFurnisher* room) {
  constexpr float kPitch = 2.45f;
  room->SetAlike(true);
  const int most = std::max(1, static_cast<int>(room->area() / 7.5f));
  std::vector<const Placed*> beds = LineWalls(room, "hospital_bed", kPitch, most);
  if (beds.empty()) {
    if (const Placed* bed = room->AgainstWall("hospital_bed", {.squeeze = true})) {
      beds.push_back(bed);
    }
  }
  const bool has_curtains = beds.size() > 1 && room->Chance(0.75);
  for (const Placed* bed : beds) {
    room->Over(*bed, "bed_panel", 0.4f);
    const bool left = room->Chance(0.5);
    const Placed* stand = room->Beside(*bed, "nightstand", left, 0.1f);
    if (stand == nullptr) room->Beside(*bed, "nightstand", !left, 0.1f);
    if (has_curtains) {
      room->At(*bed, "bed_curtain", {0.5f * kPitch, 1.2f, kQuarter}, {.width = 1.8f});
    }
    if (room->Chance(0.4)) room->At(*bed, "iv_stand", {left ? -0.72f : 0.72f, 0.35f, 0.0f});
    if (room->Chance(0.4)) room->At(*bed, "overbed_table", {left ? -0.8f : 0.8f, 1.7f, kQuarter});
  }
  room->SetAlike(false);
  room->AgainstWall("wardrobe", {.width = 1.4f, .min_width = 0.8f});
  if (room->Chance(0.6)) room->AgainstWall("washbasin", {.width = 0.6f});
  if (room->Chance(0.5)) room->NearWall("wheelchair");
  for (int i = 0; i < 2; ++i) room->NearWall("dining_chair");
  room->OnWall("wall_tv", 1.7f);
  FinishRoom(room);
}

/// A table under a lamp, with what is wheeled up to it.
void FurnishTreatment(RoomFurnisher* room) {
  const bool is_scan = room->Chance(0.35);
  const Placed* table = room->InTheOpen(is_scan ? "imaging_scanner" : "operating_table");
  if (table != nullptr && !is_scan) room->Light("surgical_lamp", table);
  for (int i = 0; i < 2; ++i) room->NearWall("medical_trolley");
  room->NearWall("monitor_stand");
  room->NearWall("iv_stand");
  room->AgainstWall("lab_wall_bench", {.width = 3.0f, .min_width = 1.4f});
  room->AgainstWall("medicine_cabinet", {.width = 1.6f, .min_width = 0.8f});
  if (room->Chance(0.5)) room->NearWall("gurney");
  FinishRoom(room);
}

void FurnishExamRoom(RoomFurnisher* room) {
  if (room->area() > 18.0f && room->Chance(0.7)) return FurnishTreatment(room);
  const Placed* couch = room->AgainstWall("exam_couch", {.anchor = placing::Anchor::kEnd});
  room->AgainstWallWithSeat("desk", "office_chair", {.width = 1.6f, .min_width = 1.1f});
  if (couch != nullptr && room->Chance(0.5)) {
    room->At(*couch, "bed_curtain", {0.0f, couch->size.z() + 0.5f, 0.0f}, {.width = 1.6f});
  }
  room->AgainstWall("medicine_cabinet", {.width = 1.2f, .min_width = 0.6f});
  room->AgainstWall("washbasin", {.width = 0.6f});
  for (int i = 0; i < 2; ++i) room->NearWall("dining_chair");
  if (room->Chance(0.6)) room->NearWall("medical_trolley");
  if (room->Chance(0.3)) room->NearWall("monitor_stand");
  room->NearWall("bin");
  room->OnWall(room->Chance(0.5) ? "poster" : "pin_board");
  FinishRoom(room);
}

void FurnishSeats(Hall* hall, int count) {
  RoomFurnisher& room = hall->room();
  room.SetAlike(true);
  for (int i = 0; i < count; ++i) {
    if (room.NearWall("seat_row", {.width = 2.3f}) == nullptr) {
      room.NearWall("seat_row", {.width = 1.2f});
    }
  }
  room.SetAlike(false);
}

void FurnishWaitingRoom(RoomFurnisher* room) {
  Hall hall(room);
  if (room->area() > 18.0f && room->Chance(0.4)) GlazedWall(&hall, 0.35f * hall.length());
  FurnishSeats(&hall, 2 + static_cast<int>(room->area() / 12.0f));
  if (hall.width() > 4.5f) {
    room->SetAlike(true);
    hall.Fill({.kind = "seat_row", .width = 2.3f, .pitch = 2.2f, .gap = 1.2f, .share = 0.7f},
              hall.Inner(1.6f));
    room->SetAlike(false);
  }
  room->InTheOpen("coffee_table");
  room->NearWall(room->Chance(0.5) ? "tall_plant" : "potted_plant");
  room->OnWall("wall_tv", 1.6f);
  room->OnWall("pin_board");
  if (room->Chance(0.4)) room->NearWall("water_cooler");
  FinishRoom(room);
}

void FurnishEntrance(RoomFurnisher* room) {
  Hall hall(room);
  FurnishSeats(&hall, 1 + static_cast<int>(room->area() / 20.0f));
  if (room->Chance(0.6)) room->NearWall("wheelchair");
  FurnishLobby(room);
}

/// A counter towards the corridor, cupboards behind it.
void FurnishNurseStation(RoomFurnisher* room) {
  Hall hall(room);
  const Look out = LookTowards(hall, room->space().mouths().front());
  const bool along = out == Look::kRight || out == Look::kLeft;
  const float across = along ? hall.width() : hall.length();
  const Placed* counter = hall.Put("service_counter", 0.5f * hall.length(), 0.5f * hall.width(),
                                   out, {.width = std::clamp(across - 2.0f, 1.2f, 5.0f)});
  if (counter != nullptr) room->At(*counter, "office_chair", {0.0f, -0.85f, 0.0f});
  room->AgainstWall("medicine_cabinet", {.width = 1.8f, .min_width = 0.8f});
  room->AgainstWall("filing_cabinet");
  room->AgainstWall("credenza", {.width = 1.6f, .min_width = 0.8f});
  room->NearWall("medical_trolley");
  room->OnWall("whiteboard", 0.0f, {.width = 1.6f});
  room->OnWall("wall_clock", 1.8f);
  FinishRoom(room);
}

/// Rails along the walls, beds and chairs on wheels left there.
void FurnishWideCorridor(RoomFurnisher* room) {
  static constexpr std::array<std::string_view, 5> kLeft = {
      "gurney", "wheelchair", "medical_trolley", "seat_row", "linen_cart"};
  const int pieces = 1 + static_cast<int>(room->area() / 18.0f);
  for (int i = 0; i < pieces; ++i) room->NearWall(room->Pick(kLeft));
  room->SetAlike(true);
  for (int i = 0; i < static_cast<int>(room->area() / 8.0f); ++i) {
    room->OnWall("hand_rail", 0.85f, {.width = 2.0f});
  }
  room->SetAlike(false);
  for (int i = 0; i < static_cast<int>(room->area() / 20.0f); ++i) {
    room->OnWall(room->Chance(0.5) ? "painting" : "pin_board");
  }
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

void FurnishSampleRoom(RoomFurnisher* room) {
  for (int i = 0; i < 2; ++i) {
    room->AgainstWall("lab_wall_bench", {.width = 2.8f, .min_width = 1.4f});
  }
  room->AgainstWall("refrigerator");
  room->AgainstWall("medicine_cabinet", {.width = 1.6f, .min_width = 0.8f});
  room->NearWall("office_chair");
  room->NearWall("bin");
  FinishRoom(room);
}

void Furnish(RoomType type, RoomFurnisher* room) {
  if (type == kWard) return FurnishWard(room);
  if (type == kExamRoom) return FurnishExamRoom(room);
  if (type == kWaitingRoom) return FurnishWaitingRoom(room);
  if (type == kLobby) return FurnishEntrance(room);
  if (type == kReception) return FurnishNurseStation(room);
  if (type == kCorridor) return FurnishWideCorridor(room);
  if (type == kLaboratory) return FurnishSampleRoom(room);
  if (type == kBathroom) return FurnishWetCell(room);
  if (type == kOffice) return FurnishOffice(room);
  if (type == kBreakRoom) return FurnishBreakRoom(room);
  if (type == kRestroom) return FurnishRestroom(room);
  if (type == kStockRoom) return FurnishStockRoom(room);
  FurnishTechnicalRoom(room);
}

constexpr std::array kFloors = {Surface{"vinyl_floor"},
                                Surface{"vinyl_floor", {196, 212, 206}},
                                Surface{"vinyl_floor", {206, 200, 186}},
                                Surface{"terrazzo"},
                                Surface{"grey_large_tile"},
                                Surface{"concrete", {214, 216, 212}}};
constexpr std::array kHard = {Surface{"grey_large_tile"}, Surface{"white_square_tile"},
                              Surface{"vinyl_floor", {180, 190, 196}}};
constexpr std::array kSoft = {Surface{"vinyl_floor", {214, 196, 168}}, Surface{"oak_planks"},
                              Surface{"vinyl_floor"}};
constexpr std::array kWalls = {
    Surface{"plaster_smooth"}, Surface{"plaster_smooth", {236, 238, 234}},
    Surface{"plaster_smooth", {222, 232, 230}}, Surface{"plaster_smooth", {240, 232, 216}}};
constexpr std::array kAccents = {Surface{"plaster_smooth", {150, 196, 190}},
                                 Surface{"plaster_smooth", {150, 180, 210}},
                                 Surface{"plaster_smooth", {188, 208, 150}},
                                 Surface{"plaster_smooth", {232, 196, 140}}, Surface{"oak"}};
constexpr std::array kCeilings = {Surface{"ceiling_grid"}, Surface{"ceiling_grid"},
                                  Surface{"plaster_smooth"}};
constexpr std::array kBooks = {StyleKind::kModern, StyleKind::kScandinavian};

constexpr BuildingKind kKind = {
    .name = "clinic",
    .min_area_m2 = 120.0f,
    .max_area_m2 = 2000.0f,
    .ceiling = {2.5f, 3.2f},
    .looks = {kFloors, kHard, kSoft, kWalls, kAccents, kCeilings, kBooks, 0.35},
    .lay = Lay,
    .furnish = Furnish};

}  // namespace

const BuildingKind& Clinic() {
  return kKind;
}

}  // namespace bulletnav::sim::building
