// SPDX-License-Identifier: MIT
#include "sim/house/furnish.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/house/placing/programs.h"

namespace bulletnav::sim {
namespace {

using Program = void (*)(placing::RoomFurnisher*);

constexpr std::array kHomePrograms = {
    std::pair<RoomType, Program>{RoomType::kLivingRoom, placing::FurnishLivingRoom},
    std::pair<RoomType, Program>{RoomType::kKitchen, placing::FurnishKitchen},
    std::pair<RoomType, Program>{RoomType::kDiningRoom, placing::FurnishDiningRoom},
    std::pair<RoomType, Program>{RoomType::kBedroom, placing::FurnishBedroom},
    std::pair<RoomType, Program>{RoomType::kKidsRoom, placing::FurnishKidsRoom},
    std::pair<RoomType, Program>{RoomType::kBathroom, placing::FurnishBathroom},
    std::pair<RoomType, Program>{RoomType::kToilet, placing::FurnishToilet},
    std::pair<RoomType, Program>{RoomType::kCorridor, placing::FurnishCorridor},
    std::pair<RoomType, Program>{RoomType::kEntry, placing::FurnishEntry},
    std::pair<RoomType, Program>{RoomType::kStudy, placing::FurnishStudy},
    std::pair<RoomType, Program>{RoomType::kLaundry, placing::FurnishLaundry},
    std::pair<RoomType, Program>{RoomType::kStorage, placing::FurnishStorage}};

Furnishing Told(const placing::Placed& placed, int room) {
  Furnishing furnishing;
  furnishing.kind = placed.kind->name;
  furnishing.room = room;
  const Eigen::Vector3f forward = placed.pose.linear().col(2);
  furnishing.yaw = Atan2(forward.x(), forward.z());
  furnishing.position = placed.pose.translation();
  furnishing.low = placed.bounds.min();
  furnishing.high = placed.bounds.max();
  furnishing.name = placed.name;
  return furnishing;
}

}  // namespace

void FurnishHomeRoom(RoomType type, placing::RoomFurnisher* room) {
  const auto program = std::find_if(kHomePrograms.begin(), kHomePrograms.end(), [&](const auto& p) {
    return p.first == type;
  });
  BULLETNAV_CHECK(program != kHomePrograms.end());
  program->second(room);
}

std::vector<Furnishing> FurnishRooms(const FloorPlan& plan, const HouseStyle& style,
                                     void (*furnish)(RoomType, placing::RoomFurnisher*),
                                     const Rng& rng, MeshBuilder* builder,
                                     const Refurnish& refurnish) {
  BULLETNAV_CHECK_EQ(plan.rooms.size(), style.rooms.size());
  const std::vector<Rng> rngs = RoomRngs(rng, static_cast<int>(plan.rooms.size()), refurnish);
  std::vector<Furnishing> furniture;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const int room = static_cast<int>(i);
    placing::RoomSpace space(plan, style, room);
    placing::RoomFurnisher furnisher(&space, style.rooms[i], rngs[i].Fork("room", i), builder);
    furnisher.SetCommonRng(rngs[i].Fork("common"));
    furnish(plan.rooms[i].type, &furnisher);
    for (const placing::Placed& placed : furnisher.placed()) {
      furniture.push_back(Told(placed, room));
    }
  }
  return furniture;
}

std::vector<std::vector<std::string_view>> FurnishHouse(const FloorPlan& plan,
                                                        const HouseStyle& style, const Rng& rng,
                                                        MeshBuilder* builder) {
  std::vector<std::vector<std::string_view>> kinds(plan.rooms.size());
  for (const Furnishing& piece : FurnishRooms(plan, style, FurnishHomeRoom, rng, builder)) {
    kinds[static_cast<std::size_t>(piece.room)].push_back(FindFurniture(piece.kind).name);
  }
  return kinds;
}

}  // namespace bulletnav::sim
