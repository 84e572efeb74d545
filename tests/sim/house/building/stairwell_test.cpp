// SPDX-License-Identifier: MIT
#include "sim/house/building/stairwell.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/house/architecture.h"
#include "sim/house/building/building_plan.h"
#include "sim/house/building/decorate.h"
#include "sim/house/furnish.h"
#include "sim/house/plan/assemble.h"
#include "sim/house/plan/passage.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::sim::building {
namespace {

constexpr std::uint64_t kSeeds = 12;

/// A stairwell of 5 m by 6 m whose door to the outside is in the middle of one wall.
FloorPlan OneRoom() {
  FloorPlan plan;
  Room room;
  room.type = RoomType::kStairwell;
  room.name = "stairwell";
  room.outline = {{-2.5f, -3.0f}, {-2.5f, 3.0f}, {2.5f, 3.0f}, {2.5f, -3.0f}};
  plan.rooms.push_back(room);
  plan.footprint = {{-2.6f, -3.1f}, {-2.6f, 3.1f}, {2.6f, 3.1f}, {2.6f, -3.1f}};
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanPoint grow(0.05f, 0.05f);
    const PlanPoint a = room.outline[i];
    const PlanPoint b = room.outline[(i + 1) % 4];
    plan.walls.push_back(
        {a + grow.cwiseProduct(a.cwiseSign()), b + grow.cwiseProduct(b.cwiseSign()), 0.1f, true});
  }
  Opening door;
  door.kind = OpeningKind::kArch;
  door.a = {-2.55f, -0.5f};
  door.b = {-2.55f, 0.5f};
  door.wall_thickness = 0.1f;
  door.room_a = 0;
  plan.openings.push_back(door);
  return plan;
}

FloorPlan Dug(std::uint64_t seed) {
  FloorPlan plan = OneRoom();
  DigPits({}, Rng(seed, "stairwell_test"), &plan);
  return plan;
}

SceneMesh MeshOf(const FloorPlan& plan) {
  HouseStyle style;
  style.rooms.resize(plan.rooms.size());
  style = DrawBuildingStyle(Office(), plan, Rng(1, "style"));
  MeshBuilder builder;
  BuildArchitecture(plan, style, &builder);
  TextureCache textures;
  return builder.Finish(&textures);
}

TEST(Stairwell, LeavesFloorBeforeDoorsAndAWayToIt) {
  int dug = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const FloorPlan plan = Dug(seed);
    dug += static_cast<int>(plan.pits.size());
    EXPECT_TRUE(plan::IsPassable(plan, 0.24f));
    for (const Pit& pit : plan.pits) {
      const Eigen::AlignedBox2f box(pit.low(), pit.high());
      EXPECT_GE(box.exteriorDistance(PlanPoint(-2.5f, 0.0f)), 0.9f);
      EXPECT_LT(box.volume(), 0.8f * plan.area());
      EXPECT_GE(pit.depth, 1.3f);
      EXPECT_TRUE(pit.first_drop == 0.0f || pit.first_drop >= 0.41f);
    }
  }
  EXPECT_GE(dug, static_cast<int>(kSeeds) - 1);
}

TEST(Stairwell, IsTurnedWithItsPlan) {
  for (int how = 0; how < 8; ++how) {
    FloorPlan plan = Dug(3);
    const Pit before = plan.pits.at(0);
    plan::Turn(how, &plan);
    const Pit& pit = plan.pits.at(0);
    EXPECT_NEAR(Eigen::AlignedBox2f(pit.low(), pit.high()).volume(), before.length * before.width,
                1e-4f);
    for (const PlanPoint& p : pit.Outline()) {
      const PlanPoint middle = 0.5f * (pit.low() + pit.high());
      EXPECT_TRUE(IsInside(plan.rooms[0].outline, p + 0.02f * (middle - p))) << how;
    }
  }
}

/// What stands on the floor is one island; steps and the pit's floor are others or none.
TEST(Stairwell, TheWalkableFloorEndsAtItsEdges) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    FloorPlan plan = Dug(seed);
    plan::Turn(static_cast<int>(seed % 8), &plan);
    const Navmesh navmesh(MeshOf(plan), {});
    ASSERT_FALSE(navmesh.islands().empty());
    const auto& corners = navmesh.triangle_corners();
    const NavmeshQuery query(navmesh);
    const auto mouth = query.IslandOf({plan.openings[0].a.x(), 0.0f, plan.openings[0].a.y()});
    ASSERT_TRUE(mouth.has_value());
    for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
      if (navmesh.triangle_islands()[t] != *mouth) continue;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(corners[3 * t + k].y(), 0.2f, 0.21f);
    }
  }
}

/// Bodies that push outwards from the floor in all directions stay on it.
TEST(Stairwell, NoBodyFalls) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const FloorPlan plan = Dug(seed);
    const PhysicsWorld world(MeshOf(plan));
    Rng rng(seed, "walk");
    CapsuleBody body(world, BodySpec::Locobot());
    BodyPose start;
    start.position = {-1.95f, 0.0f, 0.0f};
    body.Reset(start);
    for (int step = 0; step < 150; ++step) {
      body.Move({0.25, 0.0, step % 5 == 0 ? rng.Uniform(-2.0, 2.0) : 0.0});
      ASSERT_NEAR(body.pose().position.y(), 0.0, 0.05) << step;
    }
  }
}

TEST(Stairwell, IsDugNowhereElse) {
  FloorPlan plan = OneRoom();
  plan.rooms[0].type = RoomType::kCorridor;
  DigPits({}, Rng(1, "stairwell_test"), &plan);
  EXPECT_TRUE(plan.pits.empty());
}

TEST(Stairwell, NothingStandsOverAPit) {
  int pits = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Rng rng(seed, "over_pits");
    const FloorPlan plan = GenerateBuildingPlan(Workshop(), rng, {100.0f, 220.0f});
    pits += static_cast<int>(plan.pits.size());
    if (plan.pits.empty()) continue;
    MeshBuilder builder;
    const auto pieces = FurnishRooms(plan, DrawBuildingStyle(Workshop(), plan, rng),
                                     Workshop().furnish, rng, &builder);
    for (const Furnishing& piece : pieces) {
      for (const Pit& pit : plan.pits) {
        const Eigen::AlignedBox2f box(pit.low(), pit.high());
        if (piece.position.y() > 0.5f) continue;  // hung on a wall
        EXPECT_FALSE(box.contains(PlanPoint(piece.position.x(), piece.position.z())))
            << piece.kind << " " << seed;
      }
    }
  }
  EXPECT_GE(pits, 2);
}

}  // namespace
}  // namespace bulletnav::sim::building
