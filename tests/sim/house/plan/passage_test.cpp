// SPDX-License-Identifier: MIT
#include "sim/house/plan/passage.h"

#include <gtest/gtest.h>

#include "sim/math/pose.h"

namespace bulletnav::sim::plan {
namespace {

/// Two rooms of 2 m by 3 m side by side with a door in the wall at x = 0; the entry door is west.
FloorPlan TwoRooms() {
  FloorPlan plan;
  plan.rooms = {{RoomType::kEntry, "entry", {{-2.05f, 0}, {-2.05f, 3}, {-0.05f, 3}, {-0.05f, 0}}},
                {RoomType::kStudy, "study", {{0.05f, 0}, {0.05f, 3}, {2.05f, 3}, {2.05f, 0}}}};
  plan.footprint = {{-2.25f, -0.2f}, {-2.25f, 3.2f}, {2.25f, 3.2f}, {2.25f, -0.2f}};
  Opening entry;
  entry.a = {-2.15f, 1.0f};
  entry.b = {-2.15f, 1.9f};
  entry.room_a = 0;
  Opening door;
  door.a = {0.0f, 1.9f};
  door.b = {0.0f, 1.1f};
  door.wall_thickness = 0.1f;
  door.room_a = 0;
  door.room_b = 1;
  plan.openings = {entry, door};
  return plan;
}

TEST(IsPassable, NeedsADoorAsWideAsTheBody) {
  FloorPlan plan = TwoRooms();
  EXPECT_TRUE(IsPassable(plan, 0.24f));
  EXPECT_FALSE(IsPassable(plan, 0.45f));
  plan.openings.pop_back();
  EXPECT_FALSE(IsPassable(plan, 0.1f));
}

TEST(IsPassable, MindsTheLeaf) {
  FloorPlan plan = TwoRooms();
  plan.openings[1].has_leaf = true;
  plan.openings[1].door_angle = static_cast<float>(DegToRad(90.0));
  EXPECT_TRUE(IsPassable(plan, 0.24f));
  plan.openings[1].door_angle = static_cast<float>(DegToRad(12.0));
  EXPECT_FALSE(IsPassable(plan, 0.24f));
}

}  // namespace
}  // namespace bulletnav::sim::plan
