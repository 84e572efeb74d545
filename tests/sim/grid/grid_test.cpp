// SPDX-License-Identifier: MIT
#include "sim/grid/grid.h"

#include <gtest/gtest.h>

namespace bulletnav::sim {
namespace {

TEST(Grid, CellsAndIndicesBelongTogether) {
  Grid<int> grid(7);
  for (std::size_t i = 0; i < 49; ++i) {
    EXPECT_EQ(grid.index(grid.cell(i)), i);
    EXPECT_TRUE(grid.Contains(grid.cell(i)));
  }
  EXPECT_FALSE(grid.Contains({7, 0}));
  EXPECT_FALSE(grid.Contains({0, -1}));
}

TEST(LineCost, IsTheLengthWhereNothingIsInTheWay) {
  const Grid<CellState> map(20, CellState::kFree);
  EXPECT_DOUBLE_EQ(*LineCost(map, {2, 3}, {2, 3}), 0.0);
  EXPECT_DOUBLE_EQ(*LineCost(map, {2, 3}, {5, 7}), 5.0);
  EXPECT_DOUBLE_EQ(*LineCost(map, {5, 7}, {2, 3}), 5.0);
}

TEST(LineCost, BlockedCellsBreakTheLineAndTightOnesAreDearer) {
  Grid<CellState> map(20, CellState::kFree);
  for (int y = 0; y < 20; ++y) map[Cell{10, y}] = CellState::kTight;
  EXPECT_NEAR(*LineCost(map, {5, 5}, {15, 5}), 9.0 + kTightCost, 1.1);
  map[Cell{10, 5}] = CellState::kBlocked;
  EXPECT_FALSE(LineCost(map, {5, 5}, {15, 5}));
  EXPECT_TRUE(LineCost(map, {5, 5}, {10, 5})) << "ends may be blocked";
  EXPECT_TRUE(LineCost(map, {5, 9}, {15, 9}));
}

}  // namespace
}  // namespace bulletnav::sim
