// SPDX-License-Identifier: MIT
#include "sim/house/plan/draft.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace bulletnav::sim::plan {
namespace {

/// A room L-shaped around a corner room; a third one below.
Draft ThreeRooms() {
  Draft draft;
  draft.rooms = {{RoomType::kLivingRoom, 20.0f, {{0, 0, 600, 300}, {0, 300, 300, 500}}},
                 {RoomType::kKitchen, 6.0f, {{300, 300, 600, 500}}},
                 {RoomType::kBedroom, 12.0f, {{0, 500, 600, 800}}}};
  return draft;
}

TEST(Draft, ClearLengthsLeaveOneWall) {
  Draft draft;
  draft.wall_cm = 10;
  EXPECT_FLOAT_EQ(draft.Clear(310), 3.0f);
  EXPECT_EQ(draft.Gross(3.0f), 310);
  EXPECT_EQ(draft.Gross(3.01f), 315);
}

TEST(CellGrid, KnowsWhoOwnsAPoint) {
  const CellGrid grid(ThreeRooms());
  EXPECT_EQ(grid.RoomAt(100, 400), 0);
  EXPECT_EQ(grid.RoomAt(500, 400), 1);
  EXPECT_EQ(grid.RoomAt(500, 600), 2);
  EXPECT_EQ(grid.RoomAt(-10, 100), kOutside);
  EXPECT_EQ(grid.RoomAt(100, 900), kOutside);
  EXPECT_FALSE(grid.HasOverlaps());
  EXPECT_FALSE(grid.HasPinches());
}

TEST(CellGrid, BordersJoinWhatTouches) {
  const std::vector<Border> borders = CellGrid(ThreeRooms()).Borders();
  const auto total = [&](int a, int b) {
    int sum = 0;
    for (const Border& border : borders) sum += border.Joins(a, b) ? border.length() : 0;
    return sum;
  };
  EXPECT_EQ(total(0, 1), 500);
  EXPECT_EQ(total(0, 2), 300);
  EXPECT_EQ(total(1, 2), 300);
  EXPECT_EQ(total(0, kOutside) + total(1, kOutside) + total(2, kOutside), 2 * (600 + 800));
}

TEST(CellGrid, OutlineRunsWithTheRoomToTheLeft) {
  const auto loop = CellGrid(ThreeRooms()).Outline([](int room) {
    return room == 0;
  });
  ASSERT_EQ(loop.size(), 6u);
  int twice_area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const GridPoint& p = loop[i];
    const GridPoint& q = loop[(i + 1) % loop.size()];
    twice_area += p.x * q.y - q.x * p.y;
  }
  EXPECT_EQ(twice_area, -2 * (600 * 300 + 300 * 200));
}

TEST(CellGrid, RefusesOutlinesOfSeveralPieces) {
  Draft draft = ThreeRooms();
  draft.rooms[1].boxes.push_back({700, 0, 900, 200});
  EXPECT_TRUE(CellGrid(draft)
                  .Outline([](int room) {
                    return room == 1;
                  })
                  .empty());
}

TEST(CellGrid, FindsOverlapsAndPinches) {
  Draft draft = ThreeRooms();
  draft.rooms[1].boxes[0].x0 = 290;
  EXPECT_TRUE(CellGrid(draft).HasOverlaps());
  draft.rooms = {{RoomType::kStudy, 4.0f, {{0, 0, 200, 200}, {200, 200, 400, 400}}}};
  EXPECT_TRUE(CellGrid(draft).HasPinches());
}

}  // namespace
}  // namespace bulletnav::sim::plan
