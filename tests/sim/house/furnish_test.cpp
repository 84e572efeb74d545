// SPDX-License-Identifier: MIT
#include "sim/house/furnish.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "sim/house/floor_plan_generator.h"

namespace bulletnav::sim {
namespace {

constexpr int kHouses = 60;

struct Furnished {
  FloorPlan plan;
  std::vector<std::vector<std::string_view>> kinds;
  std::size_t triangles = 0;
};

Furnished Furnish(std::uint64_t seed) {
  const Rng rng(seed, "furnish_test");
  Furnished house;
  house.plan = GenerateFloorPlan(rng.Fork("plan"));
  MeshBuilder builder;
  house.kinds = FurnishHouse(house.plan, DrawHouseStyle(house.plan, rng.Fork("style")),
                             rng.Fork("furnish"), &builder);
  house.triangles = builder.triangles();
  return house;
}

/// What tells a room's type at once: one of these must stand in it.
const std::map<RoomType, std::set<std::string_view>>& Telling() {
  static const std::map<RoomType, std::set<std::string_view>> telling = {
      {RoomType::kLivingRoom, {"sofa", "corner_sofa"}},
      {RoomType::kKitchen, {"stove"}},
      {RoomType::kDiningRoom, {"dining_table", "round_dining_table"}},
      {RoomType::kBedroom, {"double_bed", "single_bed"}},
      {RoomType::kKidsRoom, {"bunk_bed", "single_bed", "crib"}},
      {RoomType::kBathroom, {"bathtub", "shower_cabin"}},
      {RoomType::kToilet, {"toilet"}},
      {RoomType::kStudy, {"desk"}},
      {RoomType::kLaundry, {"washing_machine"}},
      {RoomType::kStorage, {"utility_shelf", "pantry_shelf"}}};
  return telling;
}

TEST(FurnishHouse, NearlyEveryRoomHasWhatTellsItsType) {
  std::map<RoomType, int> count;
  std::map<RoomType, int> lacking;
  std::string which;
  for (std::uint64_t seed = 0; seed < kHouses; ++seed) {
    const Furnished house = Furnish(seed);
    for (std::size_t i = 0; i < house.plan.rooms.size(); ++i) {
      const Room& room = house.plan.rooms[i];
      const auto found = Telling().find(room.type);
      if (found == Telling().end()) continue;
      ++count[room.type];
      const bool told = std::any_of(house.kinds[i].begin(), house.kinds[i].end(), [&](auto kind) {
        return found->second.contains(kind);
      });
      if (told) continue;
      ++lacking[room.type];
      which.append(" ").append(std::to_string(seed)).append(":").append(room.name);
    }
  }
  for (const auto& [type, rooms] : count) {
    EXPECT_LE(lacking[type], 1 + rooms / 20) << NameOf(type) << " of " << rooms << ":" << which;
  }
}

TEST(FurnishHouse, UsesTheWholeCatalogueAndStaysLight) {
  std::set<std::string_view> all;
  for (std::uint64_t seed = 0; seed < kHouses; ++seed) {
    const Furnished house = Furnish(seed);
    std::set<std::string_view> here;
    for (const auto& room : house.kinds) here.insert(room.begin(), room.end());
    all.insert(here.begin(), here.end());
    EXPECT_GE(here.size(), 25U) << seed;
    EXPECT_LE(house.triangles, 45'000U) << seed;
  }
  EXPECT_GE(all.size(), 70U);
}

TEST(FurnishHouse, DependsOnTheRngAlone) {
  const Furnished a = Furnish(3);
  const Furnished b = Furnish(3);
  EXPECT_EQ(a.kinds, b.kinds);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace bulletnav::sim
