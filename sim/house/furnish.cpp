// SPDX-License-Identifier: MIT
#include "sim/house/furnish.h"

#include "sim/base/check.h"
#include "sim/house/placing/programs.h"

namespace bulletnav::sim {
namespace {

void FurnishRoom(RoomType type, placing::RoomFurnisher* room) {
  switch (type) {
    case RoomType::kLivingRoom:
      return placing::FurnishLivingRoom(room);
    case RoomType::kKitchen:
      return placing::FurnishKitchen(room);
    case RoomType::kDiningRoom:
      return placing::FurnishDiningRoom(room);
    case RoomType::kBedroom:
      return placing::FurnishBedroom(room);
    case RoomType::kKidsRoom:
      return placing::FurnishKidsRoom(room);
    case RoomType::kBathroom:
      return placing::FurnishBathroom(room);
    case RoomType::kToilet:
      return placing::FurnishToilet(room);
    case RoomType::kCorridor:
      return placing::FurnishCorridor(room);
    case RoomType::kEntry:
      return placing::FurnishEntry(room);
    case RoomType::kStudy:
      return placing::FurnishStudy(room);
    case RoomType::kLaundry:
      return placing::FurnishLaundry(room);
    case RoomType::kStorage:
      return placing::FurnishStorage(room);
  }
}

}  // namespace

std::vector<std::vector<std::string_view>> FurnishHouse(const FloorPlan& plan,
                                                        const HouseStyle& style, const Rng& rng,
                                                        MeshBuilder* builder) {
  BULLETNAV_CHECK_EQ(plan.rooms.size(), style.rooms.size());
  std::vector<std::vector<std::string_view>> kinds;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    placing::RoomSpace space(plan, style, static_cast<int>(i));
    placing::RoomFurnisher furnisher(&space, style.rooms[i], rng.Fork("room", i), builder);
    FurnishRoom(plan.rooms[i].type, &furnisher);
    kinds.push_back(furnisher.kinds());
  }
  return kinds;
}

}  // namespace bulletnav::sim
