// SPDX-License-Identifier: MIT
#include "sim/grid/fast_marching.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "tests/support/grid_path.h"

namespace bulletnav::sim {
namespace {

constexpr int kSize = 200;

/// Free cells inside a blocked rim.
Grid<CellState> Open(int size = kSize) {
  Grid<CellState> map(size, CellState::kFree);
  for (int i = 0; i < size; ++i) {
    for (const Cell& c : {Cell{i, 0}, Cell{i, size - 1}, Cell{0, i}, Cell{size - 1, i}}) {
      map[c] = CellState::kBlocked;
    }
  }
  return map;
}

void Block(const Cell& low, const Cell& high, Grid<CellState>* map) {
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) (*map)[Cell{x, y}] = CellState::kBlocked;
  }
}

TEST(FastMarching, IsEuclideanInAnEmptyRoom) {
  const Grid<CellState> map = Open();
  for (const Cell from : {Cell{100, 100}, Cell{1, 1}, Cell{37, 150}}) {
    FastMarching march(kSize);
    march.Run(map, {from});
    double worst = 0.0;
    double sum = 0.0;
    for (int y = 1; y < kSize - 1; ++y) {
      for (int x = 1; x < kSize - 1; ++x) {
        const Cell cell{x, y};
        if (cell == from) continue;
        const double error = march.distance(cell) / Distance(from, cell) - 1.0;
        worst = std::max(worst, std::fabs(error));
        sum += error;
      }
    }
    EXPECT_LT(worst, 0.04);
    EXPECT_LT(sum / (kSize * kSize), 0.02);
  }
}

TEST(FastMarching, GoesRoundACornerOnTheShortestWay) {
  Grid<CellState> map = Open();
  Block({60, 1}, {60, 120}, &map);  // a wall with its end at y = 120
  FastMarching march(kSize);
  const Cell from{20, 40};
  const Cell to{110, 30};
  march.Run(map, {from});
  const double corner = std::hypot(60 - 20, 121 - 40) + std::hypot(110 - 60, 121 - 30);
  EXPECT_NEAR(march.distance(to) / corner, 1.0, 0.03);
}

TEST(FastMarching, AgreesWithASlowOracleAmongRandomBlocks) {
  sim::Rng rng(5, "blocks");
  for (int round = 0; round < 4; ++round) {
    Grid<CellState> map = Open(100);
    for (int i = 0; i < 14; ++i) {
      const Cell low{rng.Between(1, 85), rng.Between(1, 85)};
      Block(low, {low.x + rng.Between(0, 13), low.y + rng.Between(0, 13)}, &map);
    }
    map[Cell{2, 2}] = map[Cell{97, 97}] = CellState::kFree;
    FastMarching march(100);
    march.Run(map, {{2, 2}});
    const auto is_free = [&](double x, double y) {
      const Cell cell{static_cast<int>(x), static_cast<int>(y)};
      return map.Contains(cell) && map[cell] == CellState::kFree;
    };
    const double truth = tests::GridPathLength(100, 100, 1.0, is_free, 2.5, 2.5, 97.5, 97.5);
    if (truth < 0.0) continue;
    EXPECT_NEAR(march.distance({97, 97}), truth, 0.04 * truth + 1.0) << round;
  }
}

TEST(FastMarching, DoesNotCrossWallsNorUnknownCellsUnlessAllowed) {
  Grid<CellState> map = Open();
  Block({50, 1}, {50, 198}, &map);
  FastMarching march(kSize);
  march.Run(map, {{20, 20}});
  EXPECT_TRUE(std::isinf(march.distance({60, 20})));
  map[Cell{50, 100}] = CellState::kUnknown;
  march.Run(map, {{20, 20}});
  EXPECT_TRUE(std::isinf(march.distance({60, 20})));
  march.Run(map, {{20, 20}, true});
  EXPECT_NEAR(march.distance({60, 20}), std::hypot(30, 80) + std::hypot(10, 80), 4.0);
}

TEST(FastMarching, TightPlacesCostMoreAndAreGoneAround) {
  Grid<CellState> map = Open();
  for (int y = 1; y < kSize - 1; ++y) {
    for (int x = 80; x < 90; ++x) map[Cell{x, y}] = CellState::kTight;
  }
  FastMarching march(kSize);
  march.Run(map, {{50, 100}});
  EXPECT_NEAR(march.distance({110, 100}), 50.0 + 10.0 * kTightCost, 2.0);
  for (int x = 80; x < 90; ++x) map[Cell{x, 110}] = CellState::kFree;  // a gap to one side
  march.Run(map, {{50, 100}});
  EXPECT_LT(march.distance({110, 100}), 66.0);
}

TEST(FastMarching, GivesCellsInTheOrderOfTheirDistance) {
  Grid<CellState> map = Open();
  Block({30, 30}, {90, 40}, &map);
  FastMarching march(kSize);
  march.Start(map, {{50, 60}});
  float last = 0.0f;
  int count = 0;
  while (const auto cell = march.Next()) {
    EXPECT_GE(march.distance(*cell), last - 0.126f);
    last = std::max(last, march.distance(*cell));
    ++count;
  }
  EXPECT_EQ(count, 198 * 198 - 61 * 11);
}

TEST(FastMarching, ForgetsTheLastRun) {
  const Grid<CellState> map = Open();
  FastMarching used(kSize);
  used.Start(map, {{10, 10}});
  for (int i = 0; i < 5000; ++i) used.Next();
  FastMarching fresh(kSize);
  used.Start(map, {{120, 70}});
  fresh.Start(map, {{120, 70}});
  for (int i = 0; i < 3000; ++i) EXPECT_EQ(used.Next(), fresh.Next());
  EXPECT_TRUE(std::isinf(used.distance({10, 10})));
}

}  // namespace
}  // namespace bulletnav::sim
