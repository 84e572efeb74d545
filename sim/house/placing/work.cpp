// SPDX-License-Identifier: MIT
#include <array>

#include "sim/house/placing/programs.h"

namespace bulletnav::sim::placing {

void FurnishStudy(RoomFurnisher* room) {
  const Wish wish{.width = 1.8f, .min_width = 1.0f, .anchor = Anchor::kCentre, .squeeze = true};
  const Placed* desk = room->AgainstWallWithSeat("desk", "office_chair", wish);
  if (desk != nullptr) room->Beside(*desk, "filing_cabinet", room->Chance(0.5));
  const int shelves = room->area() > 9.0f ? 3 : 2;
  for (int i = 0; i < shelves; ++i) {
    room->AgainstWall("bookshelf", {.width = 1.8f, .min_width = 0.7f, .far_from_doors = true});
  }
  const PlanPoint centre = room->space().main_floor().center();
  const Eigen::Vector2f floor = room->space().main_floor().sizes();
  room->Rug(room->Chance(0.3) ? "round_rug" : "rug", centre, 2.2f, floor.y() > floor.x());
  room->AgainstWall("filing_cabinet");
  if (room->area() > 9.0f) room->AgainstWall("armchair", {.anchor = Anchor::kEnd});
  const Placed* low = room->AgainstWall("low_shelf");
  static constexpr std::array<std::string_view, 5> kClutter = {"globe", "books_pile", "radio",
                                                               "picture_frame", "small_plant"};
  if (low != nullptr) room->OnTops(*low, kClutter, 3);
  if (room->Chance(0.3)) room->NearWall("exercise_bike");
  if (room->Chance(0.3)) room->NearWall("guitar");
  room->NearWall("bin");
  room->NearWall("potted_plant");
  if (room->Chance(0.6)) room->NearWall("floor_lamp");
  room->Radiators();
  room->DressWindows(room->Chance(0.6));
  room->Light("ceiling_lamp");
  room->OnWall("pin_board");
  HangPictures(room, 2);
  room->OnWall("wall_clock", 1.7f);
}

void FurnishStorage(RoomFurnisher* room) {
  const int shelves = room->area() > 5.0f ? 3 : 2;
  for (int i = 0; i < shelves; ++i) {
    const std::string_view kind = room->Chance(0.6) ? "utility_shelf" : "pantry_shelf";
    room->AgainstWall(kind, {.width = 1.6f, .min_width = 0.6f, .far_from_doors = true});
  }
  room->AgainstWall("box_stack");
  if (room->Chance(0.6)) room->AgainstWall("clothes_rail");
  static constexpr std::array<std::string_view, 7> kThings = {
      "suitcase",      "step_ladder", "bicycle", "vacuum_cleaner",
      "exercise_bike", "suitcase",    "backpack"};
  for (int i = 0; i < 3; ++i) room->NearWall(room->Pick(kThings));
  room->AgainstWall("cleaning_set");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
}

void FurnishCorridor(RoomFurnisher* room) {
  const Eigen::Vector2f floor = room->space().main_floor().sizes();
  if (room->Chance(0.75)) {
    const PlanPoint centre = room->space().main_floor().center();
    room->Rug("runner_rug", centre, 0.75f * floor.maxCoeff(), floor.y() > floor.x());
  }
  static constexpr std::array<std::string_view, 4> kWalls = {"console_table", "bookshelf",
                                                             "shoe_cabinet", "low_shelf"};
  static constexpr std::array<std::string_view, 4> kClutter = {"vase", "table_lamp", "small_plant",
                                                               "picture_frame"};
  const int pieces = 1 + static_cast<int>(room->area() / 7.0f);
  for (int i = 0; i < pieces; ++i) {
    const Placed* piece = room->AgainstWall(room->Pick(kWalls), {.width = 1.2f, .min_width = 0.6f});
    if (piece == nullptr) continue;
    room->OnTops(*piece, kClutter, 2);
    if (piece->size.y() < 1.1f) room->Over(*piece, "mirror", 0.35f);
  }
  if (room->Chance(0.6)) room->NearWall("potted_plant");
  room->DressWindows(false);
  room->Light("ceiling_lamp");
  for (int i = 0; i < 2 + static_cast<int>(room->area() / 5.0f); ++i) {
    room->OnWall(room->Chance(0.75) ? "painting" : "photo_gallery");
  }
  if (room->Chance(0.5)) room->OnWall("wall_lamp", 1.6f);
}

void FurnishEntry(RoomFurnisher* room) {
  if (!room->space().mouths().empty()) {
    const PlanPoint door = room->space().mouths().front();
    const Rect floor = room->space().main_floor();
    const PlanPoint way = floor.center() - door;
    const bool turned = std::abs(way.x()) > std::abs(way.y());
    room->Rug("door_mat", door + 0.15f * way.normalized(), 0.0f, turned);
  }
  if (room->OnWall("coat_hooks", 0.45f) == nullptr) room->NearWall("coat_rack");
  const Placed* shoes = room->AgainstWall("shoe_cabinet");
  if (shoes != nullptr) {
    static constexpr std::array<std::string_view, 3> kClutter = {"vase", "small_plant",
                                                                 "picture_frame"};
    room->OnTops(*shoes, kClutter, 2);
    room->Over(*shoes, "mirror", 0.4f);
  }
  room->AgainstWall("bench");
  room->NearWall("umbrella_stand");
  room->NearWall("shoes");
  if (room->Chance(0.7)) room->NearWall("shoes");
  if (room->area() > 6.0f && room->Chance(0.5)) room->NearWall("coat_rack");
  if (room->area() > 6.0f && room->Chance(0.5)) room->AgainstWall("console_table");
  if (room->Chance(0.3)) room->NearWall("bicycle");
  if (room->Chance(0.4)) room->NearWall("backpack");
  if (room->Chance(0.5)) room->NearWall("potted_plant");
  room->DressWindows(room->Chance(0.5));
  room->Light(room->Chance(0.3) ? "chandelier" : "ceiling_lamp");
  HangPictures(room, 2);
}

}  // namespace bulletnav::sim::placing
