// SPDX-License-Identifier: MIT
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "sim/house/house.h"
#include "sim/scene/glb_writer.h"
#include "sim/simulated_body.h"
#include "tests/support/house_checks.h"
#include "tests/support/scene_checks.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

class GeneratedHouseTest : public testing::TestWithParam<int> {};

TEST_P(GeneratedHouseTest, IsAHomeThatCanBeWalkedThroughAndSeen) {
  TextureCache textures;
  const House house = GenerateHouse(static_cast<std::uint64_t>(GetParam()), &textures);
  EXPECT_GE(house.mesh.triangles.size(), 20'000U);
  EXPECT_LE(house.mesh.triangles.size(), 80'000U);
  EXPECT_GE(house.plan.rooms.size(), 4U);
  EXPECT_LE(house.plan.rooms.size(), 12U);
  EXPECT_GE(house.plan.area(), 60.0f);
  EXPECT_LE(house.plan.area(), 200.0f);

  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "house.glb";
  WriteFileAtomically(file, EncodeGlb(house.mesh));
  const ImportedScene scene = ImportScene(file);
  EXPECT_TRUE(scene.report.textures_missing.empty());
  EXPECT_EQ(scene.mesh.objects, house.mesh.objects);
  EXPECT_THAT(scene.mesh.triangle_objects, testing::Each(testing::Gt(0u)));
  const auto world = std::make_shared<const World>("house", scene, WorldOptions{});
  EXPECT_GT(tests::ConnectedShare(world->navmesh()), 0.95f);
  const NavmeshQuery query(world->navmesh());
  for (const Room& room : house.plan.rooms)
    EXPECT_TRUE(tests::IsReachable(room, query)) << room.name;

  tests::CheckWalk(world, {});
  tests::CheckDepthAgainstPhysics(*world, 2);
  tests::CheckBackendsAgree(scene.mesh, *world, 3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GeneratedHouseTest, testing::Range(1000, 1020));

TEST(GenerateHouse, DependsOnTheSeedAlone) {
  TextureCache textures;
  TextureCache used;
  used.Get("oak_planks");
  const auto first = EncodeGlb(GenerateHouse(1, &textures).mesh);
  EXPECT_EQ(Hash64(first), Hash64(EncodeGlb(GenerateHouse(1, &used).mesh)));
  EXPECT_NE(Hash64(first), Hash64(EncodeGlb(GenerateHouse(2, &textures).mesh)));
}

}  // namespace
}  // namespace bulletnav::sim
