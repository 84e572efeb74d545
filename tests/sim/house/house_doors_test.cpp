// SPDX-License-Identifier: MIT
// Doors of generated houses, turned when the house is read: in the mesh, the plan and the navmesh.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/house/architecture.h"
#include "sim/house/floor_plan_generator.h"
#include "sim/house/house_json.h"
#include "sim/house/turn_leaves.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/physics_world.h"
#include "sim/scene/export_scene.h"
#include "sim/scene/glb_writer.h"
#include "sim/scene/import.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

/// The shell of a house, written as `generate` writes houses.
class HouseDoors : public testing::Test {
 protected:
  struct Files {
    tests::TemporaryFolder folder;
    FloorPlan plan;
    std::filesystem::path glb = folder.path() / "house.glb";

    Files() {
      const Rng rng(3, "house");
      plan = GenerateFloorPlan(rng.Fork("plan"));
      const HouseStyle style = DrawHouseStyle(plan, rng.Fork("style"));
      MeshBuilder builder;
      BuildArchitecture(plan, style, &builder);
      TextureCache textures;
      SceneMesh mesh = builder.Finish(&textures);
      mesh.textures.clear();  // play no part here, and take long
      for (Material& material : mesh.materials) material.texture = -1;
      WriteFileAtomically(glb, EncodeGlb(mesh));
      WriteFileAtomically(folder.path() / "house.json",
                          ToJson({.seed = 3, .style = "modern", .plan = plan}));
    }
  };
  static const Files& files() {
    static const Files files;
    return files;
  }
  static const FloorPlan& plan() { return files().plan; }
  static ImportedScene Read(const DoorSpec& doors) {
    ImportOptions options;
    options.up = UpAxis::kY;
    options.doors = doors;
    return ImportScene(files().glb, options);
  }
  /// The plan with its leaves as the scene has them.
  static FloorPlan PlanOf(const ImportedScene& scene) {
    FloorPlan turned = plan();
    TurnLeaves(scene.doors, &turned);
    return turned;
  }
};

/// How far a point is outside an outline with right angles.
float Outside(const std::array<PlanPoint, 4>& outline, const Vec& point) {
  const PlanPoint at = PlanPoint(point.x(), point.z()) - outline[0];
  const PlanPoint along = outline[1] - outline[0];
  const PlanPoint across = outline[3] - outline[0];
  const float x = at.dot(along.normalized());
  const float y = at.dot(across.normalized());
  return std::max({-x, x - along.norm(), -y, y - across.norm()});
}

void ExpectLeavesOnPlan(const ImportedScene& scene, const FloorPlan& plan) {
  std::size_t door = 0;
  for (const Opening& opening : plan.openings) {
    if (!opening.has_leaf) continue;
    ASSERT_LT(door, scene.doors.size());
    const DoorLeaf& leaf = scene.doors[door++];
    const auto outline = LeafOutline(opening);
    EXPECT_NEAR(leaf.width, opening.width(), 0.02f);
    EXPECT_LT((PlanPoint(leaf.hinge.x(), leaf.hinge.z()) - outline[0]).norm(), 1e-4f);
    float farthest = 0.0f;
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      if (scene.mesh.objects[scene.mesh.triangle_objects[t]].name != leaf.object) continue;
      for (const std::uint32_t v : scene.mesh.triangles[t]) {
        farthest = std::max(farthest, Outside(outline, scene.mesh.positions[v]));
      }
    }
    EXPECT_GT(farthest, 0.03f) << leaf.object;  // the handle
    EXPECT_LT(farthest, 0.055f) << leaf.object;
  }
  EXPECT_EQ(door, scene.doors.size());
}

TEST_F(HouseDoors, AreWhereThePlanHasThemInEachState) {
  ASSERT_GT(plan().openings.size(), 6u);
  const ImportedScene as_built = Read({});
  ExpectLeavesOnPlan(as_built, plan());
  EXPECT_GT(as_built.doors.size(), 3u);
  for (const DoorSpec& spec :
       {DoorSpec{.state = DoorState::kClosed}, DoorSpec{.state = DoorState::kOpen},
        DoorSpec{.open_share = 0.5, .seed = 1}}) {
    const ImportedScene scene = Read(spec);
    ExpectLeavesOnPlan(scene, PlanOf(scene));
    scene.mesh.Validate();
  }
  for (const DoorLeaf& door : Read({.state = DoorState::kClosed}).doors) {
    EXPECT_FALSE(door.is_open()) << door.object;
  }
  EXPECT_EQ(Read({.state = DoorState::kOpen}).mesh.positions, as_built.mesh.positions);
}

TEST_F(HouseDoors, LetNobodyThroughWhenClosed) {
  const ImportedScene open = Read({.state = DoorState::kOpen});
  const ImportedScene closed = Read({.state = DoorState::kClosed});
  const Navmesh open_floor(open.mesh, {});
  const Navmesh closed_floor(closed.mesh, {});
  const PhysicsWorld open_physics(open.mesh);
  const PhysicsWorld closed_physics(closed.mesh);
  const NavmeshQuery open_query(open_floor);
  const NavmeshQuery closed_query(closed_floor);
  int doors = 0;
  int shut_off = 0;
  for (const Opening& opening : plan().openings) {
    if (!opening.has_leaf || opening.room_b < 0) continue;
    const PlanPoint middle = 0.5f * (opening.a + opening.b);
    const PlanPoint aside = LeftOf((opening.b - opening.a).normalized());
    const auto at = [&](float metres, float height = 0.0f) {
      const PlanPoint p = middle + metres * aside;
      return Vec(p.x(), height, p.y());
    };
    EXPECT_FALSE(open_physics.RayTest(at(-0.3f, 1.0f), at(0.3f, 1.0f)));
    EXPECT_TRUE(closed_physics.RayTest(at(-0.3f, 1.0f), at(0.3f, 1.0f)));
    const auto through = open_query.FindPath(at(-0.6f), at(0.6f));
    ASSERT_TRUE(through);
    EXPECT_LT(through->length, 2.0);
    const auto around = closed_query.FindPath(at(-0.6f), at(0.6f));
    EXPECT_TRUE(!around || around->length > 3.0) << "through a closed door";
    if (!around) ++shut_off;
    ++doors;
  }
  EXPECT_GT(doors, 2);
  EXPECT_GT(shut_off, 0);
}

/// Corners of an object's triangles.
std::vector<Vec> CornersOf(const SceneMesh& mesh, const std::string& object) {
  std::vector<Vec> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.objects[mesh.triangle_objects[t]].name != object) continue;
    for (const std::uint32_t v : mesh.triangles[t]) corners.push_back(mesh.positions[v]);
  }
  return corners;
}

void ExpectSamePoints(const std::vector<Vec>& a, const std::vector<Vec>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const Vec& p : a) {
    float nearest = 1.0f;
    for (const Vec& q : b) nearest = std::min(nearest, (p - q).norm());
    ASSERT_LT(nearest, 1e-5f);
  }
}

class ExportedHouseDoors : public HouseDoors, public testing::WithParamInterface<SceneFormat> {};

TEST_P(ExportedHouseDoors, TurnAsTheHousesOwn) {
  const ImportedScene as_built = Read({});
  const tests::TemporaryFolder folder;
  const auto file = ExportScene(as_built.mesh, "house", GetParam(), folder.path(), as_built.doors);
  for (const DoorState state : {DoorState::kOpen, DoorState::kClosed}) {
    const ImportedScene house = Read({.state = state});
    ImportOptions options;
    options.doors = DoorSpec{.state = state};
    const ImportedScene exported = ImportScene(file, options);
    EXPECT_EQ(exported.mesh.triangles.size(), house.mesh.triangles.size());
    auto door = exported.doors.begin();
    for (const DoorLeaf& leaf : house.doors) {
      SCOPED_TRACE(leaf.object);
      ExpectSamePoints(CornersOf(house.mesh, leaf.object), CornersOf(exported.mesh, leaf.object));
      if (leaf.leads_outside) continue;
      ASSERT_NE(door, exported.doors.end());
      EXPECT_EQ(door->object, leaf.object);
      EXPECT_EQ(door->angle, leaf.angle);
      ++door;
    }
    EXPECT_EQ(door, exported.doors.end());
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExportedHouseDoors,
                         testing::Values(
#ifdef BULLETNAV_READS_SDF
                             SceneFormat::kSdf,
#endif
                             SceneFormat::kSceneInstance));

TEST_F(HouseDoors, ThatAreNotKnownAreNotTurned) {
  const tests::TemporaryFolder folder;
  const auto alone = folder.path() / "alone.glb";
  std::filesystem::copy_file(files().glb, alone);
  const auto error_of = [&](const DoorSpec& spec) -> std::string {
    ImportOptions options;
    options.doors = spec;
    try {
      ImportScene(alone, options);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of({.state = DoorState::kClosed}),
              testing::AllOf(testing::HasSubstr("alone.glb: no doors are known"),
                             testing::HasSubstr("leave out import.doors")));
  EXPECT_EQ(error_of({}), "no error");
  folder.Write("alone.json", "{\"openings\": [{\"leaf\": {\"hinge\": \"c\"}}]}");
  EXPECT_THAT(error_of({.state = DoorState::kClosed}), testing::HasSubstr("alone.json"));
}

}  // namespace
}  // namespace bulletnav::sim
