// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "sim/house/building/building.h"
#include "sim/house/building/decorate.h"
#include "sim/house/furnish.h"
#include "sim/scene/glb_writer.h"
#include "sim/simulated_body.h"
#include "tests/support/house_checks.h"
#include "tests/support/scene_checks.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim::building {
namespace {

constexpr AreaLimits kSmall{120.0f, 260.0f};

class GeneratedBuildingTest : public testing::TestWithParam<const BuildingKind*> {};

TEST_P(GeneratedBuildingTest, CanBeWalkedThroughAndSeen) {
  TextureCache textures;
  const House building = GenerateBuilding(*GetParam(), 7, &textures, kSmall);
  EXPECT_EQ(building.kind, GetParam()->name);
  EXPECT_GE(building.mesh.triangles.size(), 5'000U);
  EXPECT_LE(building.mesh.triangles.size(), 150'000U);
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "building.glb";
  WriteFileAtomically(file, EncodeGlb(building.mesh));
  const ImportedScene scene = ImportScene(file);
  const auto world = std::make_shared<const World>("building", scene, WorldOptions{});
  EXPECT_GT(tests::ConnectedShare(world->navmesh()), 0.95f);
  const NavmeshQuery query(world->navmesh());
  for (const Room& room : building.plan.rooms) {
    EXPECT_TRUE(tests::IsReachable(room, query)) << room.name;
  }
  tests::CheckWalk(world, {});
  tests::CheckDepthAgainstPhysics(*world, 1);
}

TEST_P(GeneratedBuildingTest, FurnishesEveryRoomWithinItsWalls) {
  // Without light, which is most of the cost.
  const Rng rng(8, "furnished");
  House building;
  building.plan = GenerateBuildingPlan(*GetParam(), rng, kSmall);
  const HouseStyle style = DrawBuildingStyle(*GetParam(), building.plan, rng);
  MeshBuilder builder;
  building.furniture = FurnishRooms(building.plan, style, GetParam()->furnish, rng, &builder);
  std::vector<int> pieces(building.plan.rooms.size(), 0);
  for (const Furnishing& piece : building.furniture) {
    const Room& room = building.plan.rooms[static_cast<std::size_t>(piece.room)];
    ++pieces[static_cast<std::size_t>(piece.room)];
    const Eigen::Vector3f middle = 0.5f * (piece.low + piece.high);
    const float x = middle.x() * std::cos(piece.yaw) + middle.z() * std::sin(piece.yaw);
    const float z = middle.z() * std::cos(piece.yaw) - middle.x() * std::sin(piece.yaw);
    const PlanPoint at(piece.position.x() + x, piece.position.z() + z);
    EXPECT_TRUE(IsInside(room.outline, at)) << piece.kind << " in " << room.name;
    EXPECT_LE(piece.position.y() + piece.high.y(), building.plan.ceiling + 1e-3f) << piece.kind;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_GT(pieces[i], 0) << building.plan.rooms[i].name;
  }
}

std::string NameOf(const testing::TestParamInfo<const BuildingKind*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GeneratedBuildingTest,
                         testing::ValuesIn(AllKinds().begin(), AllKinds().end()), NameOf);

TEST(GenerateBuilding, DependsOnKindAndSeedAlone) {
  TextureCache textures;
  TextureCache used;
  used.Get("oak_planks");
  const auto first = EncodeGlb(GenerateBuilding(Office(), 1, &textures, kSmall).mesh);
  EXPECT_EQ(Hash64(first), Hash64(EncodeGlb(GenerateBuilding(Office(), 1, &used, kSmall).mesh)));
  EXPECT_NE(Hash64(first), Hash64(EncodeGlb(GenerateBuilding(Office(), 2, &used, kSmall).mesh)));
}

}  // namespace
}  // namespace bulletnav::sim::building
