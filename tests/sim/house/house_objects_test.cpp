// SPDX-License-Identifier: MIT
// Every triangle of a generated building knows its object and its room.
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/house/architecture.h"
#include "sim/house/floor_plan_generator.h"
#include "sim/house/furnish.h"
#include "sim/house/refine.h"
#include "sim/math/rotation.h"
#include "sim/scene/finish.h"

namespace bulletnav::sim {
namespace {

struct Home {
  FloorPlan plan;
  std::vector<Furnishing> furniture;
  SceneMesh mesh;
};

/// As GenerateHouse, without light.
Home Build(std::uint64_t seed) {
  const Rng rng(seed, "house");
  Home home;
  home.plan = GenerateFloorPlan(rng.Fork("plan"));
  const HouseStyle style = DrawHouseStyle(home.plan, rng.Fork("style"));
  MeshBuilder builder;
  BuildArchitecture(home.plan, style, &builder);
  home.furniture = FurnishRooms(home.plan, style, FurnishHomeRoom, rng.Fork("furnish"), &builder);
  static TextureCache textures;
  home.mesh = builder.Finish(&textures);
  home.mesh.Validate();
  return home;
}

/// The boxes around objects, by name.
std::map<std::string, Eigen::AlignedBox3f> BoxesOf(const SceneMesh& mesh) {
  std::map<std::string, Eigen::AlignedBox3f> boxes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Eigen::AlignedBox3f& box = boxes[mesh.objects[mesh.triangle_objects[t]].name];
    for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.positions[v]);
  }
  return boxes;
}

class HouseObjects : public testing::Test {
 protected:
  static const Home& home() {
    static const Home home = Build(1);
    return home;
  }
};

TEST_F(HouseObjects, EveryTriangleBelongsToOneInARoom) {
  std::set<std::string> rooms;
  for (const Room& room : home().plan.rooms) rooms.insert(room.name);
  ASSERT_TRUE(home().mesh.has_objects());
  EXPECT_EQ(home().mesh.objects.front(), SceneObject{});
  for (const std::uint32_t object : home().mesh.triangle_objects) {
    ASSERT_GT(object, 0u);
    EXPECT_TRUE(rooms.contains(home().mesh.objects[object].room));
  }
  std::set<std::string> names;
  std::set<std::string> categories;
  for (const SceneObject& object : home().mesh.objects) {
    EXPECT_TRUE(names.insert(object.name).second) << object.name;
    categories.insert(object.category);
  }
  EXPECT_THAT(categories, testing::IsSupersetOf({"floor", "ceiling", "wall", "door", "door_frame",
                                                 "window", "stove", "toilet", "curtain"}));
}

TEST_F(HouseObjects, AreWhereFloorsAndFurnitureAre) {
  const auto boxes = BoxesOf(home().mesh);
  for (const auto& object : home().mesh.objects) {
    if (object.category != "floor") continue;
    const auto& box = boxes.at(object.name);
    EXPECT_NEAR(box.max().y(), 0.0f, 1e-3f);
    for (const Room& room : home().plan.rooms) {
      if (room.name != object.room) continue;
      for (const PlanPoint& corner : room.outline) {
        EXPECT_LT(box.exteriorDistance(Eigen::Vector3f(corner.x(), 0, corner.y())), 1e-3f);
      }
    }
  }
  ASSERT_FALSE(home().furniture.empty());
  for (const Furnishing& piece : home().furniture) {
    const Eigen::Affine3f pose = Eigen::Translation3f(piece.position) *
                                 RotationAbout<float>(Eigen::Vector3f::UnitY(), piece.yaw);
    const Eigen::AlignedBox3f own(piece.low, piece.high);
    Eigen::AlignedBox3f box;
    for (int i = 0; i < 8; ++i) {
      box.extend(pose * own.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i)));
    }
    const auto& seen = boxes.at(piece.name);
    // A turned box is larger than what is in it.
    EXPECT_TRUE((seen.min() - box.min()).minCoeff() > -1e-3f) << piece.name;
    EXPECT_TRUE((box.max() - seen.max()).minCoeff() > -1e-3f) << piece.name;
  }
}

TEST_F(HouseObjects, StayWhenEdgesAreHalvedAndCeilingsGo) {
  SceneMesh mesh = home().mesh;
  std::vector<int> tags(mesh.triangles.size());
  RefineEdges(&mesh, &tags, 1, [&](std::uint32_t a, std::uint32_t b) {
    return (mesh.positions[a] - mesh.positions[b]).norm() > 2.0f;
  });
  mesh.Validate();
  EXPECT_GT(mesh.triangles.size(), home().mesh.triangles.size());
  const auto boxes = BoxesOf(home().mesh);
  for (const auto& [name, box] : BoxesOf(mesh)) EXPECT_TRUE(box.isApprox(boxes.at(name))) << name;

  ApplyFinish({.ceiling = false}, &mesh);
  mesh.Validate();
  for (const auto& [name, unused] : BoxesOf(mesh)) EXPECT_NE(name, "ceiling_1");
}

}  // namespace
}  // namespace bulletnav::sim
