// SPDX-License-Identifier: MIT
#include <array>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::placing {
namespace {

bool PlaceToilet(RoomFurnisher* room) {
  const Placed* toilet = room->AgainstWall("toilet", {.anchor = Anchor::kEnd, .squeeze = true});
  if (toilet != nullptr) room->OnWall("toilet_paper", 0.68f, {.near = toilet});
  return toilet != nullptr;
}

void PlaceBasin(RoomFurnisher* room, float width) {
  const Wish wish{.width = width, .min_width = 0.5f, .anchor = Anchor::kCentre};
  const Placed* basin = width > 0.0f ? room->AgainstWall("washbasin", wish) : nullptr;
  if (basin == nullptr) basin = room->AgainstWall("pedestal_basin");
  // Below a window the kinds leave their mirrors out.
  if (basin == nullptr)
    basin = room->AgainstWall("washbasin", {.width = 0.6f, .height = 1.0f, .squeeze = true});
  if (basin == nullptr) return;
  const Eigen::Vector3f at = basin->pose * Eigen::Vector3f(0.0f, 0.0f, basin->size.z() + 0.35f);
  const bool turned = std::abs(basin->pose.linear()(0, 2)) > 0.5f;
  room->Rug("bath_mat", {at.x(), at.z()}, 0.0f, turned);
  room->OnWall("towel_rail", 0.75f, {.near = basin});
}

/// Tub, shower or both.
void PlaceWash(RoomFurnisher* room) {
  const bool has_tub = room->Chance(0.65);
  const Placed* wash = nullptr;
  if (has_tub) {
    wash = room->AgainstWall(
        "bathtub",
        {.width = 1.75f, .min_width = 1.4f, .anchor = Anchor::kEnd, .far_from_doors = true});
  }
  if (wash == nullptr) wash = room->InCorner("shower_cabin");
  if (wash == nullptr && !has_tub) {
    room->AgainstWall("bathtub", {.width = 1.7f, .min_width = 1.4f, .anchor = Anchor::kEnd});
  }
  if (has_tub && room->area() > 8.0f && room->Chance(0.6)) room->InCorner("shower_cabin");
}

/// The largest first, where that leaves a place for the toilet. Returns whether there is one.
bool PlaceFittings(RoomFurnisher* room, bool toilet_first) {
  bool has_toilet = toilet_first && PlaceToilet(room);
  PlaceWash(room);
  PlaceBasin(room, room->area() > 6.0f ? 1.2f : 0.8f);
  if (!toilet_first) has_toilet = PlaceToilet(room);
  return has_toilet;
}

}  // namespace

void FurnishBathroom(RoomFurnisher* room) {
  const bool is_roomy = room->Try([](RoomFurnisher* copy) {
    return PlaceFittings(copy, false);
  });
  PlaceFittings(room, !is_roomy);
  if (room->area() > 6.0f && room->Chance(0.4)) room->AgainstWall("washing_machine");
  if (room->Chance(0.6)) room->AgainstWall("bathroom_shelf");
  if (room->Chance(0.5)) room->NearWall("laundry_basket");
  if (room->Chance(0.4)) room->NearWall("bin");
  room->OnWall("towel_rail", 0.75f);
  if (room->Chance(0.5)) room->NearWall("potted_plant");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
  if (room->Chance(0.5)) room->OnWall("mirror");
}

void FurnishToilet(RoomFurnisher* room) {
  PlaceToilet(room);
  PlaceBasin(room, 0.0f);
  if (room->Chance(0.5)) room->NearWall("bin");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
  room->OnWall(room->Chance(0.5) ? "painting" : "poster");
}

void FurnishLaundry(RoomFurnisher* room) {
  const Placed* washer = room->AgainstWall("washing_machine", {.anchor = Anchor::kEnd});
  if (washer != nullptr) {
    const Placed* dryer = room->Beside(*washer, "dryer", true, 0.01f);
    if (dryer == nullptr) room->Beside(*washer, "dryer", false, 0.01f);
    room->Over(*washer, "wall_shelf", 0.5f);
  }
  PlaceBasin(room, 0.8f);
  room->AgainstWall("utility_shelf", {.width = 1.4f, .min_width = 0.7f});
  room->OnWall("boiler", 1.25f);
  room->AgainstWall("cleaning_set");
  room->NearWall("laundry_basket");
  room->NearWall("ironing_board");
  if (room->Chance(0.7)) room->NearWall("drying_rack");
  if (room->Chance(0.5)) room->NearWall("laundry_basket");
  if (room->Chance(0.5)) room->NearWall("vacuum_cleaner");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
}

}  // namespace bulletnav::sim::placing
