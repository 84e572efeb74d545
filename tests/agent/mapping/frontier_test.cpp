// SPDX-License-Identifier: MIT
#include "agent/mapping/frontier.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

constexpr int kSize = 60;

/// Sets a box of cells.
void Fill(const sim::Cell& low, const sim::Cell& high, sim::CellState state,
          sim::Grid<sim::CellState>* map) {
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) (*map)[sim::Cell{x, y}] = state;
  }
}

/// A walled room from (10, 10) to (40, 40) with free floor; all around is unknown.
sim::Grid<sim::CellState> Room() {
  sim::Grid<sim::CellState> map(kSize, sim::CellState::kUnknown);
  for (int i = 0; i < kSize; ++i) {
    for (const sim::Cell& c :
         {sim::Cell{i, 0}, sim::Cell{i, kSize - 1}, sim::Cell{0, i}, sim::Cell{kSize - 1, i}}) {
      map[c] = sim::CellState::kBlocked;
    }
  }
  Fill({10, 10}, {40, 40}, sim::CellState::kBlocked, &map);
  Fill({11, 11}, {39, 39}, sim::CellState::kFree, &map);
  return map;
}

TEST(Frontier, AClosedRoomHasNone) {
  FrontierFinder finder(kSize, 1);
  EXPECT_FALSE(finder.Nearest(Room(), {20, 20}));
}

TEST(Frontier, IsTheOpeningInTheWall) {
  sim::Grid<sim::CellState> map = Room();
  Fill({40, 20}, {40, 30}, sim::CellState::kFree, &map);
  FrontierFinder finder(kSize, 4);
  const auto cell = finder.Nearest(map, {20, 25});
  ASSERT_TRUE(cell);
  EXPECT_EQ(*cell, (sim::Cell{40, 25}));
}

TEST(Frontier, IsTheNearestByTheWayNotTheEye) {
  sim::Grid<sim::CellState> map = Room();
  Fill({40, 35}, {40, 39}, sim::CellState::kFree, &map);  // far, straight
  Fill({10, 11}, {10, 15}, sim::CellState::kFree, &map);  // near, behind a wall
  Fill({15, 11}, {15, 37}, sim::CellState::kBlocked, &map);
  FrontierFinder finder(kSize, 4);
  const auto cell = finder.Nearest(map, {20, 20});
  ASSERT_TRUE(cell);
  EXPECT_EQ(cell->x, 40);
}

TEST(Frontier, GapsInTheViewDoNotCount) {
  sim::Grid<sim::CellState> map = Room();
  map[sim::Cell{25, 25}] = sim::CellState::kUnknown;      // makes four frontier cells
  Fill({40, 20}, {40, 30}, sim::CellState::kFree, &map);  // makes eleven
  FrontierFinder small(kSize, 1);
  EXPECT_LT(small.Nearest(map, {22, 25})->x, 30);
  FrontierFinder large(kSize, 8);
  EXPECT_EQ(large.Nearest(map, {22, 25})->x, 40);
  EXPECT_EQ(large.Nearest(map, {22, 25})->x, 40) << "the second search sees the same";
}

TEST(FrontierNear, ListsOpeningsByTheWayAndKeepsThemApart) {
  sim::Grid<sim::CellState> map = Room();
  Fill({40, 12}, {40, 34}, sim::CellState::kFree, &map);  // 23 cells wide, from (25, 23) 15 away
  Fill({10, 20}, {10, 25}, sim::CellState::kFree, &map);  // 15 away too, on the other side
  map[sim::Cell{20, 20}] = sim::CellState::kUnknown;      // too small
  FrontierFinder finder(kSize, 5);
  const std::vector<sim::Cell> ends = finder.Near(map, {24, 23}, 40.0, 8.0);
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_EQ(ends[0], (sim::Cell{10, 23}));
  EXPECT_EQ(ends[1], (sim::Cell{40, 23}));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(Distance(ends[i], ends[k]), 8.0);
  }
}

TEST(FrontierNear, LeavesOutWhatIsFarAway) {
  sim::Grid<sim::CellState> map = Room();
  Fill({40, 20}, {40, 30}, sim::CellState::kFree, &map);
  FrontierFinder finder(kSize, 4);
  EXPECT_TRUE(finder.Near(map, {20, 25}, 19.0, 5.0).empty());
  EXPECT_FALSE(finder.Near(map, {20, 25}, 21.0, 5.0).empty());
  EXPECT_EQ(finder.Nearest(map, {20, 25}), (sim::Cell{40, 25}))
      << "searches do not disturb each other";
}

}  // namespace
}  // namespace bulletnav::agent
