// SPDX-License-Identifier: MIT
#include "agent/mapping/metric_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

constexpr float kWidth = 4.0f;  // of the room, x from 0
constexpr float kDepth = 5.0f;  // z from 0 to -5

/// A scene and depth panoramas from it, taken at poses of the plane whose origin is (2, 0, -2) and
/// whose x axis is the world's -z.
class Scene {
 public:
  explicit Scene(const sim::SceneMesh& mesh, const Rig& rig = {})
      : rig_(rig), scene_(sim::MakeRenderScene(mesh, sim::Backend::kEmbree)) {}

  std::vector<float> Depth(const sim::PlanarPose& pose) const {
    const sim::BodyPose body = sim::Apply({{2, 0, -2}, 0.0}, pose);
    const Eigen::Vector3d eye = body.position + Eigen::Vector3d(0, rig_.camera_height, 0);
    return tests::RenderPanorama(*scene_, rig_.panorama,
                                 {eye.cast<float>(), static_cast<float>(body.yaw)})
        .depth;
  }

 private:
  Rig rig_;
  std::unique_ptr<const sim::RenderScene> scene_;
};

/// Obstacles must lie on the walls, and the walls be full of them. In the plane the room is
/// x from -2 to 3, y from -2 to 2.
void ExpectWalls(const MetricMap& map, double slack) {
  int on_walls = 0;
  const int size = map.states().size();
  for (int i = 0; i < size * size; ++i) {
    const sim::Cell cell{i % size, i / size};
    if (!map.IsObstacle(cell)) continue;
    const Point p = map.Centre(cell);
    const double to_wall =
        std::min({std::fabs(p.x + 2), std::fabs(p.x - 3), std::fabs(p.y + 2), std::fabs(p.y - 2)});
    EXPECT_LT(to_wall, slack) << p.x << " " << p.y;
    on_walls += to_wall < slack ? 1 : 0;
  }
  EXPECT_GT(on_walls, (4 + 5) * 2 / 0.05 * 0.9);
}

class Projections : public testing::TestWithParam<sim::Projection> {};

TEST_P(Projections, PutTheWallsOfABoxRoomIntoTheRightCells) {
  Rig rig;
  rig.panorama.projection = GetParam();
  const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth), rig);
  for (const double yaw : {0.0, 0.7, -2.0}) {
    MetricMap map(rig, {});
    const sim::PlanarPose pose{0.31, -0.12, yaw};
    map.Clear(pose);
    map.Update({{}, scene.Depth(pose)}, pose);
    ExpectWalls(map, 0.05);
    // The whole floor has been seen into, also under the camera, and nothing outside.
    for (double x = -3.05; x < 4.0; x += 0.1) {
      for (double y = -3.05; y < 3.0; y += 0.1) {
        const bool inside = x > -1.9 && x < 2.9 && y > -1.9 && y < 1.9;
        const bool outside = x < -2.1 || x > 3.1 || y < -2.1 || y > 2.1;
        const bool near = std::hypot(x - pose.x, y - pose.y) < 3.1;
        const sim::CellState state = map.states()[map.CellAt({x, y})];
        EXPECT_TRUE(!inside || !near || IsKnownFree(state)) << x << " " << y;
        EXPECT_TRUE(!outside || state == sim::CellState::kUnknown) << x << " " << y;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Projections,
                         testing::Values(sim::Projection::kCylindrical,
                                         sim::Projection::kEquirectangular,
                                         sim::Projection::kCubeStrip));

TEST(MetricMap, ViewsFromTwoPosesJoinUp) {
  const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth));
  MetricMap map({}, {});
  for (const sim::PlanarPose& pose :
       {sim::PlanarPose{0, 0, 0}, sim::PlanarPose{1.5, 1.0, 1.2}, sim::PlanarPose{-1, -1, 3}}) {
    map.Update({{}, scene.Depth(pose)}, pose);
  }
  ExpectWalls(map, 0.05);
}

TEST(MetricMap, KnowsNothingBeyondItsVision) {
  MapSpec spec;
  spec.vision = 1.5;
  const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth));
  MetricMap map({}, spec);
  map.Update({{}, scene.Depth({})}, {});
  EXPECT_EQ(map.states()[map.CellAt({1.4, 0.0})], sim::CellState::kFree);
  EXPECT_EQ(map.states()[map.CellAt({1.6, 0.0})], sim::CellState::kUnknown);
  EXPECT_FALSE(map.IsObstacle(map.CellAt({-2.0, 0.0})));
}

TEST(MetricMap, OnlyWhatIsInTheBodysHeightIsAnObstacle) {
  sim::SceneMesh mesh = tests::BoxRoom(kWidth, 2.6f, kDepth);
  // In the plane these stand 1.5 to 1.7 m ahead, at y = 1, 0 and -1.
  tests::AddBox({0.9f, 0.0f, -3.7f}, {1.1f, 0.15f, -3.5f}, {9, 9, 9}, &mesh);  // a threshold
  tests::AddBox({1.9f, 0.0f, -3.7f}, {2.1f, 0.40f, -3.5f}, {9, 9, 9}, &mesh);  // a stool
  tests::AddBox({2.9f, 1.7f, -3.7f}, {3.1f, 1.9f, -3.5f}, {9, 9, 9}, &mesh);   // a lamp
  MetricMap map({}, {});
  map.Update({{}, Scene(mesh).Depth({})}, {});
  EXPECT_FALSE(map.IsObstacle(map.CellAt({1.52, 1.0})));
  EXPECT_TRUE(map.IsObstacle(map.CellAt({1.52, 0.0})));
  EXPECT_FALSE(map.IsObstacle(map.CellAt({1.52, -1.0})));
  EXPECT_EQ(map.states()[map.CellAt({1.6, -1.0})], sim::CellState::kFree);
}

TEST(MetricMap, ObstaclesThatAreGoneFade) {
  sim::SceneMesh with = tests::BoxRoom(kWidth, 2.6f, kDepth);
  tests::AddBox({1.9f, 0.0f, -4.2f}, {2.1f, 1.0f, -4.0f}, {9, 9, 9}, &with);
  MetricMap map({}, {});
  const sim::Cell cell = map.CellAt({2.02, 0.02});
  map.Update({{}, Scene(with).Depth({})}, {});
  EXPECT_TRUE(map.IsObstacle(cell));
  const auto without = Scene(tests::BoxRoom(kWidth, 2.6f, kDepth)).Depth({});
  for (int i = 0; i < 12; ++i) map.Update({{}, without}, {});
  EXPECT_FALSE(map.IsObstacle(cell));
}

TEST(MetricMap, PlannersSeeObstaclesGrownByTheDilation) {
  for (const int dilation : {0, 1, 3}) {
    MapSpec spec;
    spec.dilation_cells = dilation;
    const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth));
    MetricMap map({}, spec);
    map.Update({{}, scene.Depth({})}, {});
    sim::Cell cell = map.CellAt({0.0, 1.5});
    const auto state_below = [&](int rows) {
      return map.states()[sim::Cell{cell.x, cell.y - rows}];
    };
    while (!map.IsObstacle(cell)) ++cell.y;
    EXPECT_EQ(state_below(dilation), sim::CellState::kBlocked);
    EXPECT_EQ(state_below(dilation + 1), sim::CellState::kTight);
    EXPECT_EQ(state_below(dilation + spec.clearance_cells), sim::CellState::kTight);
    EXPECT_EQ(state_below(dilation + spec.clearance_cells + 1), sim::CellState::kFree);
  }
}

TEST(MetricMap, FeltWallsStandFifteenCentimetresAhead) {
  MetricMap map({}, {});
  map.MarkWall({1.0, 1.0, sim::kPi / 2}, 5);
  EXPECT_TRUE(map.IsFeltWall(map.CellAt({1.0, 1.16})));
  EXPECT_TRUE(map.IsFeltWall(map.CellAt({1.09, 1.16})));
  EXPECT_FALSE(map.IsFeltWall(map.CellAt({1.16, 1.16})));
  EXPECT_FALSE(map.IsFeltWall(map.CellAt({1.0, 1.09})));
  EXPECT_EQ(map.states()[map.CellAt({1.0, 1.16})], sim::CellState::kBlocked);
  map.MarkTrack({1.0, 1.0, 0.0}, {1.0, 1.3, 0.0});
  EXPECT_EQ(map.states()[map.CellAt({1.0, 1.16})], sim::CellState::kBlocked)
      << "walls beat the track";
  map.ForgetFeltWalls();
  EXPECT_EQ(map.states()[map.CellAt({1.0, 1.16})], sim::CellState::kFree) << "the track stays";
}

/// A hall 8 m wide whose floor ends 3.5 m ahead of the place where Scene stands, x = 3.5 in the
/// plane; beyond it lies floor so much lower, or nothing if it is 0.
sim::SceneMesh Ledge(float lower) {
  const sim::Rgb8 grey = {128, 128, 128};
  sim::SceneMesh mesh;
  tests::AddQuad({-2, 0, 1}, {6, 0, 1}, {6, 0, -5.5f}, {-2, 0, -5.5f}, grey, &mesh);
  if (lower == 0.0f) return mesh;
  tests::AddQuad({-2, -lower, -5.5f}, {6, -lower, -5.5f}, {6, -lower, -15}, {-2, -lower, -15}, grey,
                 &mesh);
  return mesh;
}

/// What the map makes of places around the ledge after the body has walked up to it.
MetricMap MapOf(const sim::SceneMesh& mesh, double until) {
  const Scene scene(mesh);
  MetricMap map({}, {});
  for (double x = 0.0; x <= until; x += 0.25) map.Update({{}, scene.Depth({x, 0, 0})}, {x, 0, 0});
  return map;
}

TEST(MetricMap, FloorThatEndsAtADropIsNoWay) {
  for (const float lower : {0.0f, 0.8f, 2.8f, 20.0f}) {
    const MetricMap map = MapOf(Ledge(lower), 2.25);
    for (double y = -0.6; y <= 0.6; y += 0.05) {
      EXPECT_EQ(map.states()[map.CellAt({3.2, y})], sim::CellState::kFree) << lower << " " << y;
      bool is_blocked = false;
      for (double x = 3.4; x < 3.9; x += 0.05) {
        is_blocked |= map.states()[map.CellAt({x, y})] == sim::CellState::kBlocked;
        EXPECT_FALSE(is_blocked && x < 3.425) << "the floor before it is one";
      }
      EXPECT_TRUE(is_blocked) << lower << " " << y;
    }
    EXPECT_FALSE(IsKnownFree(map.states()[map.CellAt({5.0, 0.0})])) << lower;
  }
}

TEST(MetricMap, WhatMayBeStairsIsNotKnownFromAfar) {
  const MetricMap map = MapOf(Ledge(0.5f), 0.5);
  EXPECT_EQ(map.states()[map.CellAt({3.3, 0.0})], sim::CellState::kFree);
  EXPECT_EQ(map.states()[map.CellAt({3.65, 0.0})], sim::CellState::kUnknown);
}

TEST(MetricMap, StepsAndStairsDownAreFloor) {
  const MetricMap step = MapOf(Ledge(0.15f), 2.25);
  EXPECT_TRUE(IsKnownFree(step.states()[step.CellAt({4.0, 0.0})]));
  const sim::Rgb8 grey = {128, 128, 128};
  sim::SceneMesh stairs = Ledge(8 * 0.17f);
  for (int i = 0; i < 8; ++i) {
    const float top = -0.17f * static_cast<float>(i + 1);
    const float z = -5.5f - 0.28f * static_cast<float>(i);
    tests::AddBox({-2, top - 0.2f, z - 0.28f}, {6, top, z}, grey, &stairs);
  }
  const MetricMap map = MapOf(stairs, 2.25);
  for (double x = 3.5; x < 4.4; x += 0.05) {
    EXPECT_FALSE(map.IsObstacle(map.CellAt({x, 0.0}))) << x;
  }
  EXPECT_TRUE(IsKnownFree(map.states()[map.CellAt({4.0, 0.0})]));
}

TEST(MetricMap, GapsInTheFloorAreNoDrops) {
  sim::SceneMesh mesh = Ledge(0.0f);
  tests::AddQuad({-2, 0, -5.6f}, {6, 0, -5.6f}, {6, 0, -9}, {-2, 0, -9}, {128, 128, 128}, &mesh);
  const MetricMap map = MapOf(mesh, 2.25);
  for (double x = 3.3; x < 5.0; x += 0.05) {
    EXPECT_FALSE(map.IsObstacle(map.CellAt({x, 0.0}))) << x;
  }
}

TEST(MetricMap, KnowsHowMuchOfItAViewContradicts) {
  const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth));
  MetricMap map({}, {});
  map.Update({{}, scene.Depth({})}, {});
  map.Update({{}, scene.Depth({0.1, 0.1, 0.05})}, {0.1, 0.1, 0.05});
  EXPECT_GT(map.contradiction().all, 100);
  EXPECT_LT(map.contradiction().share(), 0.1);
  map.Update({{}, scene.Depth({0, 0, 0.6})}, {});
  EXPECT_GT(map.contradiction().share(), 0.5);
}

TEST(MetricMap, OnlyWhatIsUnknownIsNoWay) {
  MetricMap map({}, {});
  map.MarkTrack({}, {1.0, 0.0, 0.0});
  map.MarkNoWay({1.2, 0.0}, 0.3);
  EXPECT_EQ(map.states()[map.CellAt({1.0, 0.0})], sim::CellState::kFree);
  EXPECT_EQ(map.states()[map.CellAt({1.2, 0.0})], sim::CellState::kBlocked);
  EXPECT_EQ(map.states()[map.CellAt({1.6, 0.0})], sim::CellState::kUnknown);
}

TEST(MetricMap, MovesAlongWithABodyThatNearsItsEdge) {
  const Scene scene(tests::BoxRoom(kWidth, 2.6f, kDepth));
  MapSpec spec;
  spec.size = 13.0;
  spec.vision = 3.2;
  MetricMap map({}, spec);
  const auto depth = scene.Depth({});
  map.Update({{}, depth}, {});
  map.Update({{}, depth}, {4.0, 0.5, 0.0});  // as if the room had come along
  EXPECT_TRUE(map.IsObstacle(map.CellAt({7.0, 0.5}))) << "the new wall";
  EXPECT_TRUE(map.IsObstacle(map.CellAt({3.0, -1.0}))) << "the old one, where it was";
  EXPECT_TRUE(map.states().Contains(map.CellAt({10.0, 0.5})));
}

TEST(MetricMap, ItsPictureShowsWhatItKnows) {
  MetricMap map({}, {});
  map.Update({{}, Scene(tests::BoxRoom(kWidth, 2.6f, kDepth)).Depth({})}, {});
  map.MarkWall({1.0, 0.0, 0.0}, 3);
  map.MarkNoWay({5.0, 0.0}, 0.2);
  const MapPicture picture = map.Picture();
  ASSERT_EQ(picture.kinds.size(), static_cast<std::size_t>(picture.size * picture.size));
  const auto kind = [&](double x, double y) {
    const int col = static_cast<int>(std::floor((x - picture.low_x) / picture.cell));
    const int row = static_cast<int>(std::floor((y - picture.low_y) / picture.cell));
    return picture.kinds[static_cast<std::size_t>(row * picture.size + col)];
  };
  EXPECT_EQ(kind(0.5, 0.5), MapPicture::Kind::kFree);
  EXPECT_EQ(kind(1.17, 0.0), MapPicture::Kind::kFeltWall);
  EXPECT_EQ(kind(4.0, 0.0), MapPicture::Kind::kUnknown);
  EXPECT_EQ(kind(5.0, 0.0), MapPicture::Kind::kFeltWall);
  EXPECT_TRUE(kind(0.0, 2.01) == MapPicture::Kind::kObstacle ||
              kind(0.0, 1.99) == MapPicture::Kind::kObstacle);
}

TEST(MetricMap, BlankAndBrokenDepthLeaveItEmpty) {
  MetricMap map({}, {});
  const sim::PanoramaSpec spec;
  map.Update({{}, std::vector<float>(spec.pixels(), 0.0f)}, {});
  map.Update({{}, std::vector<float>(spec.pixels(), std::nanf(""))}, {});
  EXPECT_EQ(map.states()[map.CellAt({0.5, 0.0})], sim::CellState::kUnknown);
}

TEST(MetricMap, NeedsDepth) {
  Rig rig;
  rig.has_depth = false;
  EXPECT_THROW(MetricMap(rig, {}), sim::Error);
  rig = {};
  rig.panorama.max_depth_m = 3.0f;
  EXPECT_THROW(MetricMap(rig, {}), sim::Error) << "what is clipped is no wall";
}

}  // namespace
}  // namespace bulletnav::agent
