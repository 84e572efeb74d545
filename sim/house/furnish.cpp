// SPDX-License-Identifier: MIT
#include "sim/house/furnish.h"

#include "sim/base/check.h"
#include "sim/house/furnish/programs.h"

namespace bulletnav::sim {
namespace {

void FurnishRoom(RoomType type, furnish::RoomFurnisher* room) {
  switch (type) {
    case RoomType::kLivingRoom:
      return furnish::FurnishLivingRoom(room);
    case RoomType::kKitchen:
      return furnish::FurnishKitchen(room);
    case RoomType::kDiningRoom:
      return furnish::FurnishDiningRoom(room);
    case RoomType::kBedroom:
      return furnish::FurnishBedroom(room);
    case RoomType::kKidsRoom:
      return furnish::FurnishKidsRoom(room);
    case RoomType::kBathroom:
      return furnish::FurnishBathroom(room);
    case RoomType::kToilet:
      return furnish::FurnishToilet(room);
    case RoomType::kCorridor:
      return furnish::FurnishCorridor(room);
    case RoomType::kEntry:
      return furnish::FurnishEntry(room);
    case RoomType::kStudy:
      return furnish::FurnishStudy(room);
    case RoomType::kLaundry:
      return furnish::FurnishLaundry(room);
    case RoomType::kStorage:
      return furnish::FurnishStorage(room);
  }
}

}  // namespace

std::vector<std::vector<std::string_view>> FurnishHouse(const FloorPlan& plan,
                                                        const HouseStyle& style, const Rng& rng,
                                                        MeshBuilder* builder) {
  CHECK_EQ(plan.rooms.size(), style.rooms.size());
  std::vector<std::vector<std::string_view>> kinds;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    furnish::RoomSpace space(plan, style, static_cast<int>(i));
    furnish::RoomFurnisher furnisher(&space, style.rooms[i], rng.Fork("room", i), builder);
    FurnishRoom(plan.rooms[i].type, &furnisher);
    kinds.push_back(furnisher.kinds());
  }
  return kinds;
}

}  // namespace bulletnav::sim
