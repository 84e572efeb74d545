// SPDX-License-Identifier: MIT
#include "sim/house/floor_plan.h"

#include <gtest/gtest.h>

#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

const std::vector<PlanPoint> kEll = {{0, 0}, {0, 3}, {2, 3}, {2, 1}, {4, 1}, {4, 0}};

TEST(PolygonArea, OfAnEllInEitherOrder) {
  EXPECT_FLOAT_EQ(PolygonArea(kEll), 8.0f);
  const std::vector<PlanPoint> reversed(kEll.rbegin(), kEll.rend());
  EXPECT_FLOAT_EQ(PolygonArea(reversed), 8.0f);
}

TEST(IsInside, TellsAnEllFromItsNotch) {
  EXPECT_TRUE(IsInside(kEll, {1, 2}));
  EXPECT_TRUE(IsInside(kEll, {3, 0.5f}));
  EXPECT_FALSE(IsInside(kEll, {3, 2}));
  EXPECT_FALSE(IsInside(kEll, {-1, 0.5f}));
}

TEST(LeftOf, IsTheNorthOfSomeoneGoingEast) {
  EXPECT_TRUE(LeftOf({1, 0}).isApprox(PlanPoint(0, -1)));
}

TEST(RoomTypeNames, IsTheOneFilesUse) {
  EXPECT_EQ(NameOf(RoomType::kKidsRoom), "kids_room");
  EXPECT_EQ(NameOf(RoomType::kStorage), "storage");
}

/// A door in a wall along x; room_a lies north of it (smaller z).
Opening EastwardDoor() {
  Opening door;
  door.a = {1.0f, 2.0f};
  door.b = {1.9f, 2.0f};
  door.wall_thickness = 0.12f;
  door.has_leaf = true;
  return door;
}

TEST(LeafOutline, LiesInTheWallWhenShut) {
  const auto leaf = LeafOutline(EastwardDoor());
  EXPECT_TRUE(leaf[0].isApprox(PlanPoint(1.0f, 1.94f)));
  EXPECT_TRUE(leaf[1].isApprox(PlanPoint(1.9f, 1.94f)));
  EXPECT_TRUE(leaf[2].isApprox(PlanPoint(1.9f, 1.98f)));
}

TEST(LeafOutline, StandsIntoTheRoomItOpensInto) {
  Opening door = EastwardDoor();
  door.door_angle = static_cast<float>(kPi / 2);
  auto leaf = LeafOutline(door);
  EXPECT_TRUE(leaf[1].isApprox(PlanPoint(1.0f, 1.04f), 1e-5f));
  EXPECT_TRUE(leaf[2].isApprox(PlanPoint(1.04f, 1.04f), 1e-5f));
  door.opens_into_a = false;
  door.hinge_at_a = false;
  leaf = LeafOutline(door);
  EXPECT_TRUE(leaf[1].isApprox(PlanPoint(1.9f, 2.96f), 1e-5f));
  EXPECT_TRUE(leaf[2].isApprox(PlanPoint(1.86f, 2.96f), 1e-5f));
}

TEST(FloorPlan, AreaIsOfTheRooms) {
  FloorPlan plan;
  plan.rooms = {{RoomType::kStudy, "study", kEll}, {RoomType::kToilet, "toilet", kEll}};
  EXPECT_FLOAT_EQ(plan.area(), 16.0f);
}

}  // namespace
}  // namespace bulletnav::sim
