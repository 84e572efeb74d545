// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::placing {
namespace {

constexpr float kQuarter = 0.5f * std::numbers::pi_v<float>;
constexpr std::array<std::string_view, 6> kTableClutter = {"books_pile", "bowl_of_fruit", "candles",
                                                           "laptop",     "vase",          "plates"};
constexpr std::array<std::string_view, 8> kShelfClutter = {
    "vase",  "picture_frame", "small_plant", "table_lamp",
    "radio", "books_pile",    "candles",     "globe"};

bool IsTurned(const Placed& piece) {
  return std::abs(piece.pose.linear()(0, 2)) > 0.5f;
}

/// Opposite the television: against the wall there, or in the open with its back to the room.
const Placed* PlaceSofa(RoomFurnisher* room, const Placed* screen) {
  if (room->Chance(0.3) && room->area() > 16.0f) {
    if (const Placed* sofa = room->InCorner("corner_sofa")) return sofa;
  }
  const Wish wish{.width = 2.2f, .min_width = 1.5f, .anchor = Anchor::kCentre, .facing = screen};
  if (screen == nullptr) return room->AgainstWall("sofa", wish);
  const Placed* sofa = nullptr;
  if (room->space().main_floor().sizes().minCoeff() > 4.8f) {
    for (const float distance : {3.4f, 3.1f, 2.8f}) {
      if (sofa != nullptr) break;
      sofa = room->At(*screen, "sofa", {0.0f, distance, 2.0f * kQuarter}, {.width = 2.0f});
    }
  }
  if (sofa == nullptr) sofa = room->AgainstWall("sofa", wish);
  if (sofa == nullptr) sofa = room->AgainstWall("sofa", {.width = 1.4f, .squeeze = true});
  return sofa != nullptr ? sofa : room->InTheOpen("sofa", {.width = 1.5f, .near = screen});
}

void FurnishSeats(RoomFurnisher* room, const Placed& sofa) {
  const float depth = sofa.kind->name == "corner_sofa" ? 1.0f : sofa.size.z();
  const Eigen::Vector3f before = sofa.pose * Eigen::Vector3f(0.0f, 0.0f, depth + 0.7f);
  const float width = static_cast<float>(room->rng().Uniform(2.2, 3.2));
  room->Rug("rug", {before.x(), before.z()}, width, IsTurned(sofa));
  const Placed* table = room->At(sofa, "coffee_table", {0.0f, depth + 0.72f, 0.0f});
  if (table != nullptr) room->OnTops(*table, kTableClutter, room->rng().Between(1, 3));
  const float aside = 0.5f * sofa.size.x();
  const bool left_first = room->Chance(0.5);
  for (const bool left : {left_first, !left_first}) {
    if (room->Chance(0.55)) {
      const float x = left ? aside + 0.75f : -aside - 0.75f;
      room->At(sofa, "armchair", {x, depth + 0.6f, left ? -kQuarter : kQuarter});
    }
    const std::string_view beside = room->Chance(0.5) ? "floor_lamp" : "side_table";
    const Placed* small = room->Beside(sofa, beside, left, 0.06f);
    if (small != nullptr) room->OnTop(*small, room->Chance(0.6) ? "table_lamp" : "small_plant");
  }
}

}  // namespace

void HangPictures(RoomFurnisher* room, int count) {
  static constexpr std::array<std::string_view, 6> kKinds = {
      "painting", "painting", "painting", "photo_gallery", "poster", "mirror"};
  for (int i = 0; i < count; ++i) room->OnWall(room->Pick(kKinds));
}

void FurnishLivingRoom(RoomFurnisher* room) {
  if (room->area() > 18.0f && room->Chance(0.35)) {
    const Placed* fire = room->AgainstWall("fireplace", {.anchor = Anchor::kCentre});
    if (fire != nullptr) {
      room->OnTops(*fire, kShelfClutter, 2);
      room->Over(*fire, room->Chance(0.5) ? "mirror" : "painting", 0.25f);
    }
  }
  const Placed* screen = room->AgainstWall(
      "tv_stand",
      {.width = 1.9f, .min_width = 1.2f, .anchor = Anchor::kCentre, .far_from_doors = true});
  const Placed* sofa = PlaceSofa(room, screen);
  if (sofa != nullptr) {
    room->Over(*sofa, room->Chance(0.7) ? "painting" : "photo_gallery", 0.35f);
    FurnishSeats(room, *sofa);
  }
  static constexpr std::array<std::string_view, 5> kWalls = {"bookshelf", "sideboard", "low_shelf",
                                                             "display_cabinet", "piano"};
  const int pieces = std::clamp(static_cast<int>(room->area() / 8.0f), 1, 4);
  room->AgainstWall("bookshelf", {.width = 1.6f, .min_width = 0.8f});
  for (int i = 1; i < pieces; ++i) {
    const Placed* piece = room->AgainstWall(room->Pick(kWalls), {.far_from_doors = true});
    if (piece != nullptr) room->OnTops(*piece, kShelfClutter, 3);
  }
  if (room->area() > 24.0f) room->AgainstWall("armchair", {.anchor = Anchor::kEnd});
  room->NearWall("tall_plant", {.far_from_doors = true});
  if (room->Chance(0.6)) room->NearWall("potted_plant");
  if (room->Chance(0.4)) room->NearWall("floor_lamp");
  if (room->Chance(0.2)) room->NearWall("guitar");
  if (room->Chance(0.25)) room->NearWall("pet_bed");
  room->Radiators();
  room->DressWindows(true);
  static constexpr std::array<std::string_view, 4> kLamps = {"chandelier", "ceiling_lamp",
                                                             "ceiling_lamp", "fan_lamp"};
  room->Light(room->Pick(kLamps));
  HangPictures(room, 2 + static_cast<int>(room->area() / 10.0f));
  if (room->Chance(0.5)) room->OnWall("wall_clock", 1.7f);
}

void FurnishDiningRoom(RoomFurnisher* room) {
  const float width = room->area() > 14.0f ? 2.2f : 1.6f;
  const Placed* table = nullptr;
  if (room->Chance(0.25)) table = room->InTheOpen("round_dining_table");
  for (const float share : {1.0f, 0.85f, 0.7f, 0.6f}) {
    if (table == nullptr) table = room->InTheOpen("dining_table", {.width = share * width});
  }
  if (table != nullptr) {
    const Eigen::Vector3f centre = table->box.center();
    if (room->Chance(0.6)) {
      room->Rug("rug", {centre.x(), centre.z()}, table->size.x() + 1.1f, IsTurned(*table));
    }
    room->ChairsAround(*table, "dining_chair", 8);
    room->OnTop(*table, room->Chance(0.5) ? "bowl_of_fruit" : "vase");
    const int settings = room->Chance(0.5) ? room->rng().Between(2, 5) : 0;
    for (int i = 0; i < settings; ++i) room->OnTop(*table, "table_setting");
    room->Light(room->Chance(0.6) ? "pendant_lamp" : "chandelier", table);
  } else {
    room->Light("ceiling_lamp");
  }
  static constexpr std::array<std::string_view, 4> kWalls = {"sideboard", "display_cabinet",
                                                             "sideboard", "low_shelf"};
  const int pieces = room->area() > 14.0f ? 3 : 2;
  for (int i = 0; i < pieces; ++i) {
    const std::string_view kind = i == 1 ? "display_cabinet" : room->Pick(kWalls);
    const Placed* piece = room->AgainstWall(kind, {.anchor = Anchor::kCentre});
    if (piece == nullptr) continue;
    room->OnTops(*piece, kShelfClutter, 3);
    if (piece->size.y() < 1.1f) room->Over(*piece, "painting", 0.4f);
  }
  if (room->Chance(0.6)) room->NearWall("tall_plant", {.far_from_doors = true});
  room->NearWall("potted_plant");
  room->Radiators();
  room->DressWindows(true);
  HangPictures(room, 2);
  if (room->Chance(0.4)) room->OnWall("wall_clock", 1.7f);
}

}  // namespace bulletnav::sim::placing
