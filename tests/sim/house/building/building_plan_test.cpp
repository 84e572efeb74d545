// SPDX-License-Identifier: MIT
#include "sim/house/building/building_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/house/plan/passage.h"

namespace bulletnav::sim::building {
namespace {

constexpr std::uint64_t kSeeds = 24;

class BuildingPlanTest : public testing::TestWithParam<const BuildingKind*> {
 protected:
  static FloorPlan Plan(std::uint64_t seed) {
    return GenerateBuildingPlan(*GetParam(), Rng(seed, "building_plan_test"));
  }
};

/// What lies under the walls: the footprint less the rooms, and the same from the walls themselves.
void ExpectTiled(const FloorPlan& plan) {
  float under_walls = 0.0f;
  for (const Wall& wall : plan.walls) under_walls += (wall.b - wall.a).norm() * wall.thickness;
  const float left = PolygonArea(plan.footprint) - plan.area();
  EXPECT_GT(left, 0.0f);
  // Walls overlap in corners and crossings only.
  EXPECT_NEAR(left, under_walls, 0.08f * under_walls);
}

TEST_P(BuildingPlanTest, IsWithinItsLimitsAndTilesItsFootprint) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const FloorPlan plan = Plan(seed);
    EXPECT_GE(plan.area(), GetParam()->min_area_m2);
    EXPECT_LE(plan.area(), GetParam()->max_area_m2);
    EXPECT_GE(plan.ceiling, GetParam()->ceiling.low - 0.05f);
    EXPECT_LE(plan.ceiling, GetParam()->ceiling.high + 0.05f);
    ExpectTiled(plan);
  }
}

TEST_P(BuildingPlanTest, EveryRoomIsReachedThroughDoorsWideEnough) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const FloorPlan plan = Plan(seed);
    EXPECT_TRUE(plan::IsPassable(plan, 0.2f));
    std::set<int> entered;
    int entries = 0;
    for (const Opening& opening : plan.openings) {
      if (!opening.IsPassage()) continue;
      entries += opening.room_b < 0 ? 1 : 0;
      entered.insert({opening.room_a, opening.room_b});
      EXPECT_GE(opening.width(), 0.78f);
      EXPECT_LT(opening.top, plan.ceiling);
    }
    EXPECT_EQ(entries, 1);
    entered.erase(-1);
    EXPECT_EQ(entered.size(), plan.rooms.size());
  }
}

TEST_P(BuildingPlanTest, DiffersFromSeedToSeedAndNotFromCallToCall) {
  std::set<std::pair<std::size_t, float>> sizes;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const FloorPlan plan = Plan(seed);
    sizes.emplace(plan.rooms.size(), plan.area());
  }
  EXPECT_EQ(sizes.size(), kSeeds);
  EXPECT_EQ(Plan(3).footprint, Plan(3).footprint);
}

TEST_P(BuildingPlanTest, KeepsToNarrowerLimits) {
  const AreaLimits limits{200.0f, 260.0f};
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const FloorPlan plan = GenerateBuildingPlan(*GetParam(), Rng(seed, "limits"), limits);
    EXPECT_GE(plan.area(), limits.min_m2);
    EXPECT_LE(plan.area(), limits.max_m2);
  }
  EXPECT_THROW(CheckLimits(*GetParam(), {200.0f, 210.0f}), Error);
  EXPECT_THROW(CheckLimits(*GetParam(), {1.0f, 300.0f}), Error);
}

std::string NameOf(const testing::TestParamInfo<const BuildingKind*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BuildingPlanTest,
                         testing::ValuesIn(AllKinds().begin(), AllKinds().end()), NameOf);

TEST(BuildingKinds, AreFoundByNameAndListedInOrder) {
  const auto all = AllKinds();
  for (const BuildingKind* kind : all) EXPECT_EQ(&FindKind(kind->name), kind);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto* a, const auto* b) {
    return a->name < b->name;
  }));
  try {
    FindKind("ofice");
    FAIL();
  } catch (const Error& error) {
    std::string names = "home";
    for (const BuildingKind* kind : all) names.append(", ").append(kind->name);
    EXPECT_THAT(error.what(), testing::HasSubstr(names));
  }
}

}  // namespace
}  // namespace bulletnav::sim::building
