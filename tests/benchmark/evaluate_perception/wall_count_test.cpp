// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/wall_count.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "sim/house/floor_plan_generator.h"
#include "sim/math/rng.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

using Eigen::Vector3d;

int Walls(const sim::SceneMesh& mesh, const Vector3d& from, const Vector3d& to) {
  const sim::PhysicsWorld scene(mesh);
  const int walls = WallsBetween(scene, from, to);
  EXPECT_EQ(walls, WallsBetween(scene, to, from));
  return walls;
}

TEST(WallCount, ALineThroughAnOpenDoorCrossesNone) {
  EXPECT_EQ(Walls(tests::TwoRooms(), {1, 0, -2}, {7, 0, -2}), 0);
}

TEST(WallCount, AWallIsOneWhereverItIsCrossed) {
  EXPECT_EQ(Walls(tests::TwoRooms(), {1, 0, -1}, {7, 0, -1}), 1);
  EXPECT_EQ(Walls(tests::TwoRooms(), {1, 0, -0.5}, {1, 0, -3.5}), 0);
  EXPECT_EQ(Walls(tests::TwoRooms(), {3.8, 0, -3.9}, {4.2, 0, -2.6}), 1);  // very aslant
  EXPECT_EQ(Walls(tests::TwoRooms(), {3.5, 0, -3.5}, {3.5, 0, -3.5}), 0);
}

TEST(WallCount, FurnitureIsNoWallNorIsADoorThatStandsOpen) {
  sim::SceneMesh mesh = tests::TwoRooms();
  tests::AddBox({2, 0, -3}, {2.5f, 2.2f, -1}, {90, 60, 30}, &mesh);             // a wardrobe
  tests::AddBox({4.1f, 0, -1.6f}, {4.9f, 2.02f, -1.56f}, {90, 60, 30}, &mesh);  // a leaf
  EXPECT_EQ(Walls(mesh, {1, 0, -2}, {7, 0, -2}), 0);
  EXPECT_EQ(Walls(mesh, {4.5, 0, -1}, {4.5, 0, -2}), 0);
  EXPECT_EQ(Walls(mesh, {1, 0, -1.2}, {7, 0, -1.2}), 1);
}

TEST(WallCount, AShutDoorIsAWall) {
  sim::SceneMesh mesh = tests::TwoRooms();
  tests::AddBox({3.98f, 0, -2.45f}, {4.02f, 2.03f, -1.55f}, {90, 60, 30}, &mesh);
  EXPECT_EQ(Walls(mesh, {1, 0, -2}, {7, 0, -2}), 1);
}

TEST(WallCount, WallsInARowAreCountedEach) {
  sim::SceneMesh mesh = tests::TwoRooms();
  tests::AddBox({2, 0, -4}, {2.2f, 2.5f, 0}, {90, 60, 30}, &mesh);
  tests::AddBox({6, 0, -4}, {6.1f, 2.5f, 0}, {90, 60, 30}, &mesh);
  EXPECT_EQ(Walls(mesh, {1, 0, -1}, {7, 0, -1}), 3);
  EXPECT_EQ(Walls(mesh, {1, 0, -2}, {7, 0, -2}), 2);
}

TEST(WallCount, LowCeilingsDoNotHideWalls) {
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.2f, 4);
  tests::AddBox({3.94f, 0, -4}, {4.06f, 2.2f, -2}, {180, 170, 150}, &mesh);
  EXPECT_EQ(Walls(mesh, {1, 0, -3}, {7, 0, -3}), 1);
  EXPECT_EQ(Walls(mesh, {1, 0, -1}, {7, 0, -1}), 0);
}

/// Where the way from a to b meets the line through c and d: shares of both, unless parallel.
std::optional<std::pair<float, float>> Meet(const Eigen::Vector2f& a, const Eigen::Vector2f& b,
                                            const Eigen::Vector2f& c, const Eigen::Vector2f& d) {
  Eigen::Matrix2f sides;
  sides << b - a, c - d;
  if (std::abs(sides.determinant()) < 1e-3f) return std::nullopt;
  const Eigen::Vector2f shares = sides.inverse() * (c - a);
  return std::pair{shares.x(), shares.y()};
}

/// Walls by the plan; absent where the way comes near an end of a wall, a jamb or a window.
std::optional<int> WallsOfPlan(const sim::FloorPlan& plan, const Eigen::Vector2f& from,
                               const Eigen::Vector2f& to) {
  constexpr float kNear = 0.3f;
  int walls = 0;
  for (const sim::Wall& wall : plan.walls) {
    const auto at = Meet(from, to, wall.a, wall.b);
    const float near = kNear / (wall.b - wall.a).norm();
    if (!at || at->second < -near || at->second > 1.0f + near) continue;
    if (at->first < -0.1f || at->first > 1.1f) continue;
    if (at->first < 0.0f || at->first > 1.0f) return std::nullopt;
    if (at->second < near || at->second > 1.0f - near) return std::nullopt;
    ++walls;
  }
  for (const sim::Opening& opening : plan.openings) {
    const auto at = Meet(from, to, opening.a, opening.b);
    const float near = kNear / opening.width();
    if (!at || at->first < 0.0f || at->first > 1.0f) continue;
    if (at->second < -near || at->second > 1.0f + near) continue;
    if (!opening.IsPassage() || at->second < near || at->second > 1.0f - near) return std::nullopt;
    const bool is_shut = opening.has_leaf && opening.door_angle == 0.0f;
    walls -= is_shut ? 0 : 1;
  }
  return walls;
}

Eigen::Vector2f PlaceIn(const sim::FloorPlan& plan, sim::Rng* rng) {
  Eigen::AlignedBox2f box;
  for (const sim::PlanPoint& corner : rng->Pick(plan.rooms).outline) box.extend(corner);
  const auto across = static_cast<float>(rng->Uniform());
  const auto along = static_cast<float>(rng->Uniform());
  return box.min() + box.sizes().cwiseProduct(Eigen::Vector2f(across, along));
}

TEST(WallCount, AgreesWithTheFloorPlansOfHouses) {
  int compared = 0;
  int different = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const sim::FloorPlan plan = sim::GenerateFloorPlan(sim::Rng(seed, "shell_house"));
    const sim::PhysicsWorld scene(tests::ShellHouse(seed));
    sim::Rng rng(seed, "walls");
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector2f a = PlaceIn(plan, &rng);
      const Eigen::Vector2f b = PlaceIn(plan, &rng);
      const auto walls = WallsOfPlan(plan, a, b);
      if (!walls) continue;
      ++compared;
      const int counted = WallsBetween(scene, {a.x(), 0, a.y()}, {b.x(), 0, b.y()});
      different += counted == *walls ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 200);
  EXPECT_LE(different, compared / 100);
}

}  // namespace
}  // namespace bulletnav::bench
