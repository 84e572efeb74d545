// SPDX-License-Identifier: MIT
#include <array>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::placing {
namespace {

constexpr std::array<std::string_view, 4> kNightClutter = {"table_lamp", "books_pile", "candles",
                                                           "picture_frame"};
constexpr std::array<std::string_view, 5> kDresserClutter = {"vase", "picture_frame", "small_plant",
                                                             "books_pile", "candles"};
constexpr std::array<std::string_view, 4> kToys = {"teddy_bear", "toy_blocks", "books_pile",
                                                   "globe"};

const Placed* PlaceBed(RoomFurnisher* room) {
  const Wish wish{.anchor = Anchor::kCentre, .far_from_doors = true};
  const Placed* bed = nullptr;
  if (room->area() > 8.5f) bed = room->AgainstWall("double_bed", wish);
  if (bed == nullptr) {
    bed = room->AgainstWall("single_bed", {.anchor = Anchor::kEnd, .far_from_doors = true});
  }
  if (bed == nullptr) bed = room->Alongside("single_bed");
  if (bed == nullptr) bed = room->AgainstWall("single_bed", {.squeeze = true});
  if (bed == nullptr) return nullptr;
  const Eigen::Vector3f foot = bed->pose * Eigen::Vector3f(0.0f, 0.0f, 0.75f * bed->size.z());
  const bool turned = std::abs(bed->pose.linear()(0, 2)) > 0.5f;
  if (room->Chance(0.75)) room->Rug("rug", {foot.x(), foot.z()}, bed->size.x() + 1.2f, turned);
  for (const bool left : {true, false}) {
    const Placed* stand = room->Beside(*bed, "nightstand", left);
    if (stand == nullptr) continue;
    room->OnTop(*stand, "table_lamp");
    room->OnTops(*stand, kNightClutter, 1);
  }
  if (room->Chance(0.8)) room->Over(*bed, "painting", 0.35f);
  if (room->Chance(0.35)) room->At(*bed, "bench", {0.0f, bed->size.z() + 0.06f, 0.0f});
  return bed;
}

void PlaceDesk(RoomFurnisher* room) {
  const Placed* desk =
      room->AgainstWall("desk", {.width = 1.2f, .min_width = 1.0f, .seat = "office_chair"});
  if (desk != nullptr) room->SeatAt(*desk, "office_chair", 0.2f);
}

}  // namespace

void FurnishBedroom(RoomFurnisher* room) {
  const Placed* bed = PlaceBed(room);
  room->AgainstWall(
      "wardrobe",
      {.width = room->area() > 12.0f ? 2.4f : 1.6f, .min_width = 0.8f, .anchor = Anchor::kEnd});
  const Placed* dresser = room->AgainstWall("dresser", {.anchor = Anchor::kCentre, .facing = bed});
  if (dresser != nullptr) {
    room->OnTops(*dresser, kDresserClutter, 3);
    room->Over(*dresser, room->Chance(0.6) ? "mirror" : "wall_tv", 0.3f);
  }
  static constexpr std::array<std::string_view, 6> kWalls = {
      "vanity_table", "armchair", "standing_mirror", "low_shelf", "bookshelf", "clothes_rail"};
  const int more = static_cast<int>(room->area() / 7.0f);
  for (int i = 0; i < more; ++i) room->AgainstWall(room->Pick(kWalls));
  if (room->area() > 14.0f && room->Chance(0.4)) PlaceDesk(room);
  if (room->Chance(0.7)) room->NearWall("potted_plant");
  if (room->Chance(0.4)) room->NearWall("laundry_basket");
  if (room->Chance(0.3)) room->NearWall("suitcase");
  if (room->Chance(0.3)) room->NearWall("slippers");
  room->Radiators();
  room->DressWindows(true);
  room->Light(room->Chance(0.3) ? "fan_lamp" : "ceiling_lamp");
  HangPictures(room, room->rng().Between(1, 3));
}

void FurnishKidsRoom(RoomFurnisher* room) {
  static constexpr std::array<std::string_view, 3> kBeds = {"bunk_bed", "single_bed", "crib"};
  const Wish in_corner{.anchor = Anchor::kEnd, .far_from_doors = true};
  if (room->AgainstWall(room->Pick(kBeds), in_corner) == nullptr) {
    if (room->Alongside("single_bed") == nullptr) {
      room->AgainstWall("single_bed", {.anchor = Anchor::kEnd, .squeeze = true});
    }
  }
  const PlanPoint centre = room->space().main_floor().center();
  const Eigen::Vector2f floor = room->space().main_floor().sizes();
  room->Rug("rug", centre, 2.2f, floor.y() > floor.x());
  const Placed* shelf = room->AgainstWall("toy_shelf");
  if (shelf != nullptr) room->OnTops(*shelf, kToys, 3);
  room->AgainstWall("toy_chest");
  room->AgainstWall("wardrobe", {.width = 1.4f, .min_width = 0.8f, .anchor = Anchor::kEnd});
  if (room->Chance(0.5)) room->AgainstWall("dollhouse");
  if (room->area() > 11.0f && room->Chance(0.5))
    room->NearWall("play_tent", {.far_from_doors = true});
  if (room->Chance(0.6)) room->InTheOpen("kids_table");
  if (room->Chance(0.5)) room->NearWall("rocking_horse");
  if (room->Chance(0.4)) PlaceDesk(room);
  if (room->Chance(0.5)) room->AgainstWall("low_shelf", {.width = 1.2f, .min_width = 0.8f});
  if (room->Chance(0.4)) room->NearWall("easel");
  room->NearWall("ball");
  if (room->Chance(0.5)) room->NearWall("ball");
  if (room->Chance(0.4)) room->NearWall("backpack");
  room->Radiators();
  room->DressWindows(room->Chance(0.7));
  room->Light("ceiling_lamp");
  for (int i = 0; i < 3; ++i) room->OnWall("poster");
  if (room->Chance(0.4)) room->OnWall("wall_shelf", 1.35f);
  if (room->Chance(0.3)) room->OnWall("wall_clock", 1.7f);
}

}  // namespace bulletnav::sim::placing
