// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_map.h"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using testing::Each;
using testing::Gt;
using testing::Lt;

constexpr double kSize = 500.0;  // pixels a side: 5 m of world, for the margins of half a metre

/// A room of 4 x 4 m, x in [0, 4], z in [-4, 0], with a red box in it, open at its top.
sim::SceneMesh RoomWithBox(float height) {
  sim::SceneMesh mesh = tests::BoxRoom(4, 2.6f, 4);
  tests::AddBox({2.5f, 0.0f, -1.5f}, {3.5f, height, -0.5f}, {200, 0, 0}, &mesh);
  return mesh;
}

SceneMap MapOf(const sim::SceneMesh& mesh, std::optional<sim::FloorPlan> plan = {}) {
  return MakeSceneMap(mesh, sim::Navmesh(mesh, {}), std::move(plan));
}

class Drawn {
 public:
  explicit Drawn(const SceneMap& map)
      : place_(map, {Canvas::Point(0, 0), Canvas::Point(kSize, kSize)}),
        canvas_(static_cast<int>(kSize), static_cast<int>(kSize), kWhite) {
    DrawSceneMap(map, place_, &canvas_);
    image_ = canvas_.ToImage();
  }

  /// Colour at a place of the world.
  std::vector<int> At(double x, double z) const {
    const Canvas::Point p = place_.At(x, z);
    const std::uint8_t* c = image_.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
    return {c[0], c[1], c[2]};
  }
  const MapPlace& place() const { return place_; }

 private:
  MapPlace place_;
  Canvas canvas_;
  sim::Image image_;
};

TEST(SceneMap, WorldLiesTrueToScaleInTheMiddleOfTheBox) {
  const SceneMap map = MapOf(RoomWithBox(0.8f));
  const MapPlace place(map, {Canvas::Point(100, 0), Canvas::Point(100 + kSize, 2 * kSize)});
  EXPECT_NEAR(place.pixels_per_metre(), 100.0, 0.5);
  EXPECT_NEAR((place.At(2, -2) - Canvas::Point(100 + kSize / 2, kSize)).norm(), 0.0, 2.0);
  EXPECT_NEAR((place.At(3, -1) - place.At(2, -2) - Canvas::Point(100, 100)).norm(), 0.0, 1.0);
}

TEST(SceneMap, TheScaleBarLiesBelowScenesOfAllSizes) {
  for (const float side : {3.0f, 12.0f, 60.0f}) {
    const MapPlace place(MapOf(tests::BoxRoom(side, 3, side)),
                         {Canvas::Point(0, 0), Canvas::Point(kSize, kSize)});
    EXPECT_LT(place.At(0, 0).y(), place.box().max().y() - 12.0) << side;  // 6 + half of its text
  }
}

TEST(SceneMap, FloorFurnitureAndOutsideCanBeToldApart) {
  const Drawn drawn(MapOf(RoomWithBox(0.8f)));
  const auto floor = drawn.At(1, -2);
  EXPECT_GT(floor[2], floor[0]) << "walkable: bluish";
  const auto box = drawn.At(3, -1);
  EXPECT_GT(box[0], box[2] + 30) << "reddish";
  EXPECT_GT(box[2], 100) << "but muted";
  EXPECT_THAT(drawn.At(4.3, -2), Each(Gt(250)));
}

TEST(SceneMap, WhatTheCutGoesThroughIsFurnitureThoughItsTopIsMissing) {
  sim::SceneMesh mesh = RoomWithBox(2.3f);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const auto is_top = [&](std::uint32_t corner) {
      return std::abs(mesh.positions[corner].y() - 2.3f) < 1e-3f;
    };
    return is_top(t[0]) && is_top(t[1]) && is_top(t[2]);
  });
  mesh.triangle_materials.resize(mesh.triangles.size());
  const Drawn drawn(MapOf(mesh));
  const auto box = drawn.At(3, -1);
  EXPECT_GT(box[0], box[2] + 30);
}

TEST(SceneMap, OutdoorsBetweenTwoWingsIsNoFurniture) {
  const Drawn drawn(MapOf(tests::LCorridor(4, 4, 1.2f, 2.6f)));
  EXPECT_THAT(drawn.At(1, -3), Each(Gt(250)));
}

TEST(SceneMap, WallsAreCutWhereThereIsNoPlan) {
  const Drawn drawn(MapOf(RoomWithBox(0.8f)));
  EXPECT_THAT(drawn.At(0.0, -2), Each(Lt(170)));
}

TEST(SceneMap, PlanGivesSolidWallsWithGapsForDoors) {
  sim::FloorPlan plan;
  plan.rooms.push_back({sim::RoomType::kKitchen, "kitchen", {{0, 0}, {4, 0}, {4, -4}, {0, -4}}});
  plan.walls.push_back({{-0.1f, 0.1f}, {-0.1f, -4.1f}, 0.2f, true});
  plan.walls.push_back({{-0.1f, -4.1f}, {4.1f, -4.1f}, 0.2f, true});
  sim::Opening door;
  door.a = {-0.1f, -1.5f};
  door.b = {-0.1f, -2.5f};
  door.room_a = 0;
  plan.openings.push_back(door);
  sim::Opening window = door;
  window.kind = sim::OpeningKind::kWindow;
  window.a = {1.0f, -4.1f};
  window.b = {2.0f, -4.1f};
  plan.openings.push_back(window);
  const SceneMap map = MapOf(RoomWithBox(0.8f), plan);
  EXPECT_TRUE(map.sections.empty());
  const Drawn drawn(map);
  EXPECT_THAT(drawn.At(-0.1, -1.0), Each(Lt(100)));
  EXPECT_THAT(drawn.At(-0.1, -3.0), Each(Lt(100)));
  EXPECT_THAT(drawn.At(-0.1, -2.0), Each(Gt(200))) << "the door";
  EXPECT_THAT(drawn.At(-0.1, -4.15), Each(Lt(100))) << "the corner is closed";
  const auto glass = drawn.At(1.5, -4.1);
  EXPECT_GT(glass[2], glass[0] + 10) << "the window";
}

}  // namespace
}  // namespace bulletnav::bench
