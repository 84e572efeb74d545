// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/walk_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/grid_path.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using testing::DoubleNear;
using testing::Optional;

/// Distance over the grid from one point to another; both are on it.
double Measure(const WalkGrid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  WalkDistances distances(grid);
  distances.MeasureFrom(grid.CellAt(from).value());
  return distances.To(grid.CellAt(to).value());
}

TEST(WalkGridTest, InABoxDistancesAreStraight) {
  const sim::Navmesh navmesh(tests::BoxRoom(9, 2.5f, 7), {});
  const WalkGrid grid(navmesh, LargestStorey(navmesh));
  sim::Rng rng(1, "walk_grid_test");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d a(rng.Uniform(0.3, 8.7), 0, rng.Uniform(-6.7, -0.3));
    const Eigen::Vector3d b(rng.Uniform(0.3, 8.7), 0, rng.Uniform(-6.7, -0.3));
    const double exact = (b - a).norm();
    EXPECT_THAT(Measure(grid, a, b), DoubleNear(exact, 0.02 * exact + 0.08));
  }
}

TEST(WalkGridTest, InALCorridorTheyBendAroundTheCorner) {
  const sim::Navmesh navmesh(tests::LCorridor(8, 8, 1.2f, 2.5f), {});
  const WalkGrid grid(navmesh, LargestStorey(navmesh));
  const Eigen::Vector3d a(1, 0, -0.6);
  const Eigen::Vector3d b(7.4, 0, -7);
  const Eigen::Vector3d corner(6.87, 0, -1.13);
  const double exact = (corner - a).norm() + (b - corner).norm();
  EXPECT_THAT(Measure(grid, a, b), DoubleNear(exact, 0.02 * exact + 0.08));
}

TEST(WalkGridTest, AgreesWithDijkstraOverTheSameCells) {
  const sim::Navmesh navmesh(tests::ShellHouse(1), {});
  const WalkGrid grid(navmesh, LargestStorey(navmesh));
  const sim::NavmeshQuery query(navmesh);
  const Eigen::Vector3d corner = grid.Centre({0, 0});
  const double size = 0.05 * grid.states().size();
  const auto is_free = [&](double x, double z) {
    const sim::Cell cell = {static_cast<int>(x / 0.05), static_cast<int>(z / 0.05)};
    return grid.states().Contains(cell) && grid.states()[cell] == sim::CellState::kFree;
  };
  sim::Rng rng(1, "walk_grid_test");
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d a = query.RandomPoint(&rng, 0).cast<double>();
    const Eigen::Vector3d b = query.RandomPoint(&rng, 0).cast<double>();
    const Eigen::Vector3d from = a - corner + Eigen::Vector3d(0.025, 0, 0.025);
    const Eigen::Vector3d to = b - corner + Eigen::Vector3d(0.025, 0, 0.025);
    const double exact =
        tests::GridPathLength(size, size, 0.05, is_free, from.x(), from.z(), to.x(), to.z());
    ASSERT_GT(exact, 0.0);
    EXPECT_GT(Measure(grid, a, b), 0.98 * exact - 0.1);
    EXPECT_LT(Measure(grid, a, b), 1.05 * exact + 0.1);
  }
}

TEST(WalkGridTest, AgreesWithDetourInHouses) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const sim::Navmesh navmesh(tests::ShellHouse(seed), {});
    const WalkGrid grid(navmesh, LargestStorey(navmesh));
    const sim::NavmeshQuery query(navmesh);
    WalkDistances distances(grid);
    sim::Rng rng(seed, "walk_grid_test");
    std::vector<double> ratios;
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3f from = query.RandomPoint(&rng, 0);
      distances.MeasureFrom(grid.CellAt(from.cast<double>()).value());
      for (int k = 0; k < 100; ++k) {
        const Eigen::Vector3f to = query.RandomPoint(&rng, 0);
        const double detour = query.GeodesicDistance(from, to);
        if (detour < 2.0) continue;
        ratios.push_back(distances.To(grid.CellAt(to.cast<double>()).value()) / detour);
      }
    }
    std::sort(ratios.begin(), ratios.end());
    const auto part = [&](double share) {
      return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
    };
    // Detour's ways may be much too long, never too short.
    EXPECT_THAT(part(0.5), DoubleNear(1.015, 0.015));
    EXPECT_GT(part(0.02), 0.98);
    EXPECT_LT(part(0.98), 1.06);
    EXPECT_LT(part(1.0), 1.12);
  }
}

TEST(WalkGridTest, FindsTheNearestFloorOnlyNearby) {
  const sim::Navmesh navmesh(tests::BoxRoom(5, 2.5f, 5), {});
  const WalkGrid grid(navmesh, LargestStorey(navmesh));
  const auto cell = grid.CellAt({0.02, 0.1, -2.5});
  ASSERT_TRUE(cell);
  EXPECT_LT((grid.Centre(*cell) - Eigen::Vector3d(0.1, grid.Centre(*cell).y(), -2.5)).norm(), 0.08);
  EXPECT_FALSE(grid.CellAt({-0.3, 0.1, -2.5}));
  EXPECT_FALSE(grid.CellAt({2.5, 2.0, -2.5}));
  EXPECT_FALSE(grid.CellAt({1e30, 0.0, 0.0}));
  EXPECT_FALSE(grid.CellAt({NAN, 0.0, 0.0}));
}

TEST(WalkGridTest, WhatCannotBeReachedIsInfinitelyFar) {
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.5f, 4);
  tests::AddBox({3.94f, 0, -4}, {4.06f, 2.5f, 0}, {90, 90, 90}, &mesh);
  const sim::Navmesh navmesh(mesh, {});
  const Storey storey = LargestStorey(navmesh);
  const WalkGrid grid(navmesh, storey);
  // The grid is of one island: the other half of the room is not on it.
  EXPECT_NE(grid.CellAt({2, 0, -2}).has_value(), grid.CellAt({6, 0, -2}).has_value());
}

TEST(WalkGridTest, TakesTheStoreyWithTheMostFloor) {
  sim::SceneMesh mesh;
  // A gentle ramp between a small and a large floor, all one island.
  tests::AddQuad({0, 0, 0}, {2, 0, 0}, {2, 0, -2}, {0, 0, -2}, {90, 90, 90}, &mesh);
  tests::AddQuad({2, 0, 0}, {8, 2, 0}, {8, 2, -2}, {2, 0, -2}, {90, 90, 90}, &mesh);
  tests::AddQuad({8, 2, 0}, {16, 2, 0}, {16, 2, -6}, {8, 2, -6}, {90, 90, 90}, &mesh);
  const sim::Navmesh navmesh(mesh, {});
  const Storey storey = LargestStorey(navmesh);
  EXPECT_THAT(storey.floor_y, DoubleNear(2.0, 0.3));
  const WalkGrid grid(navmesh, storey);
  EXPECT_TRUE(grid.CellAt({12, 2, -3}));
  EXPECT_FALSE(grid.CellAt({1, 0, -1}));
  EXPECT_FALSE(grid.CellAt({1, 2, -1}));
}

}  // namespace
}  // namespace bulletnav::bench
