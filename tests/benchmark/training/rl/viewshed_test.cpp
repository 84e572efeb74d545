// SPDX-License-Identifier: MIT
// A simulated view against rendered depth: the same maps must come of both.
#include "benchmark/training/rl/exploration/viewshed.h"

#include <gtest/gtest.h>

#include "agent/mapping/metric_map.h"
#include "sim/base/error.h"
#include "sim/physics/capsule_body.h"
#include "sim/render/renderer.h"
#include "tests/benchmark/training/rl/map_overlap.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

TEST(HeightColumns, TellWhichHeightsAreOccupied) {
  sim::SceneMesh mesh = tests::BoxRoom(4, 2.6f, 4);
  tests::AddBox({1, 0.72f, -2}, {2, 0.74f, -1}, {9, 9, 9}, &mesh);
  const HeightColumns columns(mesh, 0.0);
  const auto at = [&](double x, double z) {
    return columns.values()[static_cast<std::size_t>(columns.AlongZ(z)) *
                                static_cast<std::size_t>(columns.width()) +
                            static_cast<std::size_t>(columns.AlongX(x))];
  };
  EXPECT_EQ(at(3.03, -3.03), 1u);                               // floor
  EXPECT_EQ(at(1.53, -1.53), 1u | (1u << 14));                  // and a board at 0.72 m
  EXPECT_EQ(at(-0.53, -1.53), 0u);                              // beyond the wall
  EXPECT_EQ(at(2.03, 0.01), (1u << HeightColumns::kBits) - 1);  // the wall
  EXPECT_TRUE(columns.IsInside(columns.AlongX(2.0), columns.AlongZ(-2.0)));
  EXPECT_FALSE(columns.IsInside(columns.AlongX(-0.5), columns.AlongZ(-2.0)));
}

TEST(Viewshed, SeesOverATableAndUnderItAsACameraDoes) {
  sim::SceneMesh mesh = tests::BoxRoom(5, 2.6f, 5);
  tests::AddBox({2.0f, 0.70f, -3.4f}, {3.2f, 0.75f, -2.4f}, {9, 9, 9}, &mesh);  // a table's top
  tests::AddBox({0.5f, 0.0f, -2.5f}, {1.1f, 1.1f, -2.1f}, {9, 9, 9}, &mesh);    // a chest
  tests::AddBox({3.6f, 0.0f, -1.5f}, {4.2f, 0.45f, -0.9f}, {9, 9, 9}, &mesh);   // a stool
  const tests::MapOverlap overlap = tests::CompareMaps(mesh, 0.0, 12, 3);
  EXPECT_GT(overlap.explored, 0.97);
  EXPECT_GT(overlap.obstacles, 0.85);
}

TEST(Viewshed, MapsAGeneratedHouseAsRenderedDepthDoes) {
  const tests::MapOverlap overlap = tests::CompareMaps(tests::ShellHouse(3), 0.0, 40, 1);
  EXPECT_GT(overlap.explored, 0.95);
  EXPECT_GT(overlap.obstacles, 0.85);
}

TEST(Viewshed, CountsOnTheTrueMapWhatIsNewAlone) {
  const HeightColumns columns(tests::BoxRoom(4, 2.6f, 4), 0.0);
  Viewshed view(agent::MapSpec{}, 1.25);
  SeenGround seen;
  seen.cells.resize(columns.values().size());
  const sim::BodyPose pose{{2, 0, -2}, 0.4};
  view.Place(&columns, pose, &seen);
  view.Project({}, 0.5, 0.5, 0.0);
  const std::int64_t first = seen.count;
  EXPECT_NEAR(static_cast<double>(first) * 0.0025, 16.0, 1.0);  // all of the room, and its walls
  view.Place(&columns, pose, &seen);
  view.Project({}, 0.5, 0.5, 2.0);
  EXPECT_LT(static_cast<double>(seen.count - first) * 0.0025, 0.2);
}

TEST(Viewshed, RefusesMapsThatItCannotFill) {
  agent::MapSpec coarse;
  coarse.cell = 0.1;
  EXPECT_THROW(Viewshed(coarse, 1.25), sim::Error);
  agent::MapSpec far;
  far.vision = 5.0;
  EXPECT_THROW(Viewshed(far, 1.25), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
