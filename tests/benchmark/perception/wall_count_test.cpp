// SPDX-License-Identifier: MIT
#include "benchmark/perception/wall_count.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bulletnav::bench
