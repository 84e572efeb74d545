// SPDX-License-Identifier: MIT
// Floor is what a body can stand on indoors.
#include <string>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/navmesh/navmesh.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using Vec = Eigen::Vector3f;

constexpr Rgb8 kGrey = {128, 128, 128};
constexpr float kHigh = 2.5f;   // of rooms
constexpr float kWall = 0.15f;  // thickness
constexpr float kDoor = 0.9f;

/// A slab whose top lies at a height.
void AddSlab(const Vec& low, const Vec& high, SceneMesh* mesh) {
  AddBox(low - Vec(0, 0.1f, 0), high, kGrey, mesh);
}

/// Walls around [0, width] x [-depth, 0] between two heights, with a door to the outside in the
/// wall at z = 0.
void AddWalls(float width, float depth, float from, float to, SceneMesh* mesh) {
  AddBox({-kWall, from, -depth - kWall}, {width + kWall, to, -depth}, kGrey, mesh);
  AddBox({-kWall, from, -depth}, {0, to, 0}, kGrey, mesh);
  AddBox({width, from, -depth}, {width + kWall, to, 0}, kGrey, mesh);
  AddBox({kDoor + 1, from, 0}, {width + kWall, to, kWall}, kGrey, mesh);
  AddBox({-kWall, from, 0}, {1, to, kWall}, kGrey, mesh);
  AddBox({1, from + 2.1f, 0}, {kDoor + 1, to, kWall}, kGrey, mesh);
}

/// One room of 8 x 6 m without a ceiling.
SceneMesh OpenHall(float height = kHigh) {
  SceneMesh mesh;
  AddSlab({-kWall, 0, -6 - kWall}, {8 + kWall, 0, kWall}, &mesh);
  AddWalls(8, 6, 0, height, &mesh);
  return mesh;
}

/// Two rooms of 8 x 6 m together, without a ceiling.
SceneMesh OpenHouse() {
  SceneMesh mesh = OpenHall();
  AddBox({4, 0, -6}, {4 + kWall, kHigh, -kDoor - 1}, kGrey, &mesh);
  AddBox({4, 0, -1}, {4 + kWall, kHigh, 0}, kGrey, &mesh);
  return mesh;
}

SceneMesh RoofedHouse(float overhang) {
  SceneMesh mesh = OpenHouse();
  AddSlab({-kWall - overhang, kHigh + 0.1f, -6 - kWall - overhang},
          {8 + kWall + overhang, kHigh + 0.1f, kWall + overhang}, &mesh);
  return mesh;
}

constexpr float kFloor = 8 * 6 - 8;  // m2 less a radius and voxels at the walls, roughly
constexpr float kTolerance = 4;

/// Every walkable triangle's corners.
template <class Is>
bool AllCorners(const Navmesh& navmesh, const Is& is) {
  for (const Vec& corner : navmesh.triangle_corners()) {
    if (!is(corner)) return false;
  }
  return true;
}

bool IsInTheHouse(const Vec& p) {
  return p.x() > -1 && p.x() < 9 && p.z() < 1 && p.z() > -7;
}

TEST(Indoors, ARoofIsNoFloor) {
  const float open = Navmesh(OpenHouse(), {}).area();
  EXPECT_NEAR(open, kFloor, kTolerance);
  for (const float overhang : {0.0f, 0.5f, 3.0f}) {
    const Navmesh navmesh(RoofedHouse(overhang), {});
    EXPECT_NEAR(navmesh.area(), open, 0.5f) << overhang;
    EXPECT_TRUE(AllCorners(navmesh, [](const Vec& p) {
      return p.y() < 0.5f;
    })) << overhang;
    NavmeshSpec all;
    all.indoor_only = false;
    EXPECT_GT(Navmesh(RoofedHouse(overhang), all).area(), 1.8f * open) << overhang;
  }
}

TEST(Indoors, AFlatCeilingBetweenHigherWallsIsNoFloor) {
  SceneMesh mesh = OpenHouse();
  AddSlab({0, kHigh - 0.4f, -6}, {8, kHigh - 0.4f, 0}, &mesh);
  EXPECT_NEAR(Navmesh(mesh, {}).area(), Navmesh(OpenHouse(), {}).area(), 0.5f);
}

TEST(Indoors, GroundAroundAHouseIsNoFloor) {
  for (const bool roofed : {false, true}) {
    const SceneMesh house = roofed ? RoofedHouse(0) : OpenHouse();
    SceneMesh mesh = house;
    AddSlab({-10, 0, -20}, {20, 0, 10}, &mesh);
    const Navmesh navmesh(mesh, {});
    EXPECT_NEAR(navmesh.area(), Navmesh(house, {}).area(), 1.5f) << roofed;
    EXPECT_TRUE(AllCorners(navmesh, IsInTheHouse)) << roofed;
    NavmeshSpec all;
    all.indoor_only = false;
    EXPECT_GT(Navmesh(mesh, all).area(), 700.0f);
  }
}

TEST(Indoors, AHallWithAFrontOfPostsAndABeamIsFloorAllOver) {
  SceneMesh house;
  AddSlab({-10, 0, -20}, {20, 0, 10}, &house);
  AddBox({-kWall, 0, -6 - kWall}, {8 + kWall, kHigh, -6}, kGrey, &house);
  AddBox({-kWall, 0, -6}, {0, kHigh, 0}, kGrey, &house);
  AddBox({8, 0, -6}, {8 + kWall, kHigh, 0}, kGrey, &house);
  AddBox({-kWall, kHigh - 0.2f, 0}, {8 + kWall, kHigh, kWall}, kGrey, &house);
  for (int i = 1; i < 4; ++i) {
    const float x = 2.0f * static_cast<float>(i);
    AddBox({x, 0, 0}, {x + 0.1f, kHigh, kWall}, kGrey, &house);
  }
  const Navmesh navmesh(house, {});
  EXPECT_NEAR(navmesh.area(), 8 * 6, kTolerance);
  EXPECT_TRUE(AllCorners(navmesh, IsInTheHouse));
}

TEST(Indoors, GroundAStepBelowTheDoorIsNoFloorEither) {
  SceneMesh mesh = OpenHouse();
  AddSlab({-10, -0.6f, -20}, {20, -0.6f, 10}, &mesh);
  const Navmesh navmesh(mesh, {});
  EXPECT_NEAR(navmesh.area(), Navmesh(OpenHouse(), {}).area(), 1.5f);
  EXPECT_TRUE(AllCorners(navmesh, IsInTheHouse));
}

TEST(Indoors, TopsAreNoFloor) {
  SceneMesh mesh = RoofedHouse(0);
  const float empty = Navmesh(mesh, {}).area();
  AddBox({0, 0, -6}, {2, 0.5f, -4}, kGrey, &mesh);         // a bed in a corner
  AddBox({5, 0.7f, -4}, {7.2f, 0.75f, -2}, kGrey, &mesh);  // a table, with air below
  const Navmesh navmesh(mesh, {});
  EXPECT_EQ(navmesh.islands().size(), 1u);
  EXPECT_NEAR(navmesh.area(), empty - 2 * 2 - 2.2f * 2, 2.0f);
  NavmeshSpec all;
  all.indoor_only = false;
  EXPECT_GE(Navmesh(mesh, all).islands().size(), 3u);
}

TEST(Indoors, ATableIsNoFloorThoughChairsKeepTheFloorAway) {
  SceneMesh mesh = RoofedHouse(0);
  AddBox({4.9f, 0.7f, -4.5f}, {7.1f, 0.75f, -2.5f}, kGrey, &mesh);
  for (int i = 0; i < 4; ++i) {
    const float along = 0.05f + 0.55f * static_cast<float>(i);
    for (const float z : {-5.0f, -2.5f}) {
      AddBox({4.9f + along, 0, z}, {5.3f + along, 0.45f, z + 0.5f}, kGrey, &mesh);
    }
    for (const float x : {4.4f, 7.1f}) {
      AddBox({x, 0, -4.5f + 0.9f * along}, {x + 0.5f, 0.45f, -4.1f + 0.9f * along}, kGrey, &mesh);
    }
  }
  EXPECT_TRUE(AllCorners(Navmesh(mesh, {}), [](const Vec& p) {
    return p.y() < 0.5f;
  }));
}

TEST(Indoors, TopsOfShelvesAreNoFloorWithoutACeilingEither) {
  SceneMesh mesh = OpenHouse();
  AddBox({0, 0, -6}, {1.3f, 2.2f, -3}, kGrey, &mesh);
  EXPECT_TRUE(AllCorners(Navmesh(mesh, {}), [](const Vec& p) {
    return p.y() < 0.5f;
  }));
}

TEST(Indoors, EveryStoreyIsFloor) {
  SceneMesh mesh = OpenHouse();
  AddSlab({-kWall, 2.7f, -6 - kWall}, {8 + kWall, 2.7f, kWall}, &mesh);
  AddWalls(8, 6, 2.7f, 2.7f + kHigh, &mesh);
  for (const bool roofed : {false, true}) {
    if (roofed) AddSlab({-kWall, 5.4f, -6 - kWall}, {8 + kWall, 5.4f, kWall}, &mesh);
    const Navmesh navmesh(mesh, {});
    // Without a roof nobody knows the upper storey from a terrace, unless a way leads up.
    EXPECT_NEAR(navmesh.area(), (roofed ? 2 : 1) * kFloor, 2 * kTolerance);
    EXPECT_EQ(navmesh.islands().size(), roofed ? 2u : 1u);
  }
}

TEST(Indoors, TopsUpstairsAreNoFloor) {
  SceneMesh mesh = OpenHouse();
  AddSlab({-kWall, 2.7f, -6 - kWall}, {8 + kWall, 2.7f, kWall}, &mesh);
  AddWalls(8, 6, 2.7f, 2.7f + kHigh, &mesh);
  AddSlab({-kWall, 5.4f, -6 - kWall}, {8 + kWall, 5.4f, kWall}, &mesh);
  const float empty = Navmesh(mesh, {}).area();
  AddBox({0, 2.7f, -6}, {2, 3.2f, -4}, kGrey, &mesh);
  const Navmesh navmesh(mesh, {});
  EXPECT_EQ(navmesh.islands().size(), 2u);
  EXPECT_NEAR(navmesh.area(), empty - 2 * 2, 1.0f);
}

TEST(Indoors, AGalleryThatStepsLeadToIsFloor) {
  for (const bool roofed : {false, true}) {
    SceneMesh mesh = OpenHall(6.0f);
    if (roofed) AddSlab({-kWall, 6, -6 - kWall}, {8 + kWall, 6, kWall}, &mesh);
    for (int i = 1; i <= 12; ++i) {
      const float x = 0.3f * static_cast<float>(i);
      AddBox({x, 0, -6}, {x + 0.3f, 0.2f * static_cast<float>(i), -5}, kGrey, &mesh);
    }
    AddSlab({3.9f, 2.4f, -6}, {8, 2.4f, -3.5f}, &mesh);
    const Navmesh navmesh(mesh, {});
    const NavmeshQuery query(navmesh);
    ASSERT_EQ(navmesh.islands().size(), 1u) << roofed;
    const auto up = query.Snap({6, 2.4f, -4.5f});
    ASSERT_TRUE(up);
    EXPECT_NEAR(up->y(), 2.4f, 0.4f);
    EXPECT_GT(query.GeodesicDistance({6, 0, -1}, {6, 2.4f, -4.5f}), 6.0);
  }
}

TEST(Indoors, AnOpenSceneIsFloorAllOver) {
  SceneMesh mesh;
  AddSlab({0, 0, -20}, {20, 0, 0}, &mesh);
  AddBox({5, 0, -6}, {6, 2.5f, -5}, kGrey, &mesh);
  EXPECT_GT(Navmesh(mesh, {}).area(), 380.0f);
}

/// A slab in the open: there is nothing indoors that could count.
TEST(Indoors, SaysWhereNothingIsIndoors) {
  EXPECT_FALSE(Navmesh(OpenHouse(), {}).is_open());
  SceneMesh slab;
  AddSlab({0, 0, -6}, {6, 0, 0}, &slab);
  EXPECT_TRUE(Navmesh(slab, {}).is_open());
  NavmeshSpec all;
  all.indoor_only = false;
  EXPECT_FALSE(Navmesh(slab, all).is_open());  // not asked
}

TEST(Navmesh, NamesASceneThatIsTooLarge) {
  SceneMesh slab;
  AddSlab({0, 0, -9000}, {9000, 0, 0}, &slab);
  try {
    const Navmesh navmesh(slab, {}, "house.glb");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("house.glb: the scene is 9000 x 9000 m"), 0u)
        << error.what();
  }
}

}  // namespace
}  // namespace bulletnav::sim
