// SPDX-License-Identifier: MIT
#include "sim/physics/capsule_body.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using tests::AddQuad;
using tests::BoxRoom;
constexpr PlanarPose kStep{0.25, 0.0, 0.0};
constexpr Rgb8 kGrey = {128, 128, 128};

/// A body at (x, 0, z) of a mesh, looking along -z.
struct Walker {
  Walker(const SceneMesh& mesh, double x, double z, const BodySpec& spec = {})
      : world(mesh), body(world, spec) {
    body.Reset({{x, 0.0, z}, 0.0});
  }
  /// `n` steps ahead; returns how many collided.
  int Ahead(int n) {
    int collisions = 0;
    for (int i = 0; i < n; ++i) collisions += body.Move(kStep).collided ? 1 : 0;
    return collisions;
  }
  const Eigen::Vector3d& at() const { return body.pose().position; }

  PhysicsWorld world;
  CapsuleBody body;
};

TEST(CapsuleBody, WalksExactlyWhereNothingIsInTheWay) {
  Walker walker(BoxRoom(4, 2.6f, 6), 2, -1);
  EXPECT_EQ(walker.Ahead(8), 0);
  EXPECT_NEAR(walker.at().z(), -3.0, 1e-5);
  EXPECT_NEAR(walker.at().x(), 2.0, 1e-5);
  EXPECT_NEAR(walker.at().y(), 0.0, 1e-5);
}

TEST(CapsuleBody, StopsARadiusBeforeAWall) {
  Walker walker(BoxRoom(4, 2.6f, 6), 2, -3);
  EXPECT_GT(walker.Ahead(20), 5);
  EXPECT_NEAR(walker.at().z(), -5.9, 0.01);
  EXPECT_GE(walker.at().z(), -5.9 - 0.001);
}

TEST(CapsuleBody, LongStepsDoNotPassThroughThinWalls) {
  for (const double length : {0.25, 1.0, 5.0, 50.0}) {
    SceneMesh mesh = BoxRoom(4, 2.6f, 6);
    AddQuad({0, 0, -3}, {4, 0, -3}, {4, 2.6f, -3}, {0, 2.6f, -3}, kGrey, &mesh);
    Walker walker(mesh, 2, -1);
    for (int i = 0; i < 20; ++i) walker.body.Move({length, 0.0, 0.0});
    EXPECT_GT(walker.at().z(), -2.901) << length;
    EXPECT_LT(walker.at().z(), -2.85) << length;
  }
}

TEST(CapsuleBody, SlidesAlongAWallOnlyIfAskedTo) {
  for (const bool sliding : {true, false}) {
    BodySpec spec;
    spec.sliding = sliding;
    Walker walker(BoxRoom(4, 2.6f, 6), 2, -5.88, spec);
    walker.body.Move({0.0, 0.0, DegToRad(45)});  // half left of the wall ahead
    const MoveResult result = walker.body.Move(kStep);
    EXPECT_TRUE(result.collided);
    EXPECT_EQ(result.contacts, 1);
    const double expected = sliding ? 2.0 - 0.25 * std::sqrt(0.5) : 2.0;
    EXPECT_NEAR(walker.at().x(), expected, sliding ? 0.01 : 0.02);
  }
}

TEST(CapsuleBody, StaysInACorner) {
  Walker walker(BoxRoom(4, 2.6f, 6), 0.5, -5.5);
  walker.body.Move({0.0, 0.0, DegToRad(30)});
  for (int i = 0; i < 50; ++i) walker.body.Move(kStep);
  EXPECT_NEAR(walker.at().x(), 0.1, 0.01);
  EXPECT_NEAR(walker.at().z(), -5.9, 0.01);
}

TEST(CapsuleBody, StepsOverAThresholdAndOntoAStairButNotOntoATable) {
  struct Case {
    float height;
    bool passes;
  };
  for (const Case& c :
       {Case{0.02f, true}, Case{0.18f, true}, Case{0.3f, false}, Case{0.7f, false}}) {
    SceneMesh mesh = BoxRoom(4, 2.6f, 6);
    AddBox({0, 0, -3.0f}, {4, c.height, -2.0f}, kGrey, &mesh);
    Walker walker(mesh, 2, -1);
    const int collisions = walker.Ahead(6);
    EXPECT_EQ(collisions == 0, c.passes) << c.height;
    EXPECT_NEAR(walker.at().y(), c.passes ? c.height : 0.0f, 1e-3) << c.height;
    if (c.passes) {
      walker.Ahead(6);
      EXPECT_NEAR(walker.at().y(), 0.0, 1e-3) << "steps down again";
    }
  }
}

TEST(CapsuleBody, ClimbsAStairAndComesDownAgain) {
  SceneMesh mesh = BoxRoom(4, 6, 12);
  for (int i = 0; i < 8; ++i) {
    const auto step = static_cast<float>(i);
    AddBox({0, 0, -8}, {4, 0.17f * (step + 1), -2 - 0.28f * step}, kGrey, &mesh);
  }
  Walker walker(mesh, 2, -1);
  EXPECT_EQ(walker.Ahead(16), 0);
  EXPECT_NEAR(walker.at().y(), 8 * 0.17, 1e-3);
  walker.body.Move({0.0, 0.0, kPi});
  EXPECT_EQ(walker.Ahead(16), 0);
  EXPECT_NEAR(walker.at().y(), 0.0, 1e-3);
}

TEST(CapsuleBody, StopsAtALedge) {
  SceneMesh mesh;
  AddQuad({0, 0, 0}, {4, 0, 0}, {4, 0, -3}, {0, 0, -3}, kGrey, &mesh);
  AddQuad({0, -1, -3}, {4, -1, -3}, {4, -1, -9}, {0, -1, -9}, kGrey, &mesh);
  Walker walker(mesh, 2, -1);
  EXPECT_GT(walker.Ahead(20), 0);
  EXPECT_NEAR(walker.at().y(), 0.0, 1e-5);
  EXPECT_LT(walker.at().z(), -2.7);
  EXPECT_GT(walker.at().z(), -3.06);
}

TEST(CapsuleBody, IsStoppedByADoorLeafAndGoesUnderALintel) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({0, 0, -3.1f}, {1.6f, 2.6f, -3}, kGrey, &mesh);           // wall left of a doorway
  AddBox({2.4f, 0, -3.1f}, {4, 2.6f, -3}, kGrey, &mesh);           // and right of it
  AddBox({1.6f, 2.05f, -3.1f}, {2.4f, 2.6f, -3}, kGrey, &mesh);    // lintel
  AddBox({1.6f, 0, -3.85f}, {1.64f, 2.05f, -3.1f}, kGrey, &mesh);  // leaf standing open
  Walker walker(mesh, 2, -1);
  EXPECT_EQ(walker.Ahead(14), 0);
  EXPECT_NEAR(walker.at().z(), -4.5, 1e-4);
  walker.body.Reset({{1.2, 0, -3.5}, -kPi / 2});  // towards +x, into the leaf
  walker.Ahead(10);
  EXPECT_NEAR(walker.at().x(), 1.5, 0.01);
}

TEST(CapsuleBody, ResetPushesOutOfAWallItTouches) {
  Walker walker(BoxRoom(4, 2.6f, 6), 0.05, -3);
  EXPECT_NEAR(walker.at().x(), 0.1, 0.01);
  EXPECT_NEAR(walker.at().z(), -3, 1e-4);
}

TEST(CapsuleBody, ResetRefusesWhatIsNoPlaceAndKeepsTheOldPose) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({1, 0, -3.12f}, {3, 2.6f, -3}, kGrey, &mesh);  // a wall
  AddBox({3, 0.6f, -6}, {4, 0.7f, -5}, kGrey, &mesh);   // a table
  Walker walker(mesh, 2, -1);
  for (const Eigen::Vector3d& bad : {Eigen::Vector3d(2, 0, -3.06),   // inside the wall
                                     Eigen::Vector3d(3.5, 0, -5.5),  // under the table
                                     Eigen::Vector3d(9, 0, -3),      // outside
                                     Eigen::Vector3d(2, 1.5, -1),    // in the air
                                     Eigen::Vector3d(2, NAN, -1)}) {
    EXPECT_THROW(walker.body.Reset({bad, 0.0}), PoseError) << bad.transpose();
    EXPECT_NEAR(walker.at().z(), -1.0, 1e-6);
  }
}

TEST(CapsuleBody, LocobotIsWiderAndLower) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({0, 1.0f, -4}, {4, 2.6f, -3}, kGrey, &mesh);  // head room of 1 m
  Walker tall(mesh, 2, -2);
  tall.Ahead(20);
  EXPECT_GT(tall.at().z(), -3.0);
  Walker low(mesh, 2, -2, BodySpec::Locobot());
  low.Ahead(20);
  EXPECT_NEAR(low.at().z(), -5.82, 0.01);
}

TEST(CapsuleBody, BadSpecsAreRefused) {
  const PhysicsWorld world(BoxRoom(4, 2.6f, 6));
  BodySpec spec;
  spec.radius = 0.0f;
  EXPECT_THROW(CapsuleBody(world, spec), Error);
  spec.radius = 1.0f;
  EXPECT_THROW(CapsuleBody(world, spec), Error);
}

/// Random pillars, slabs and slanted quads: whatever the steps, the body's axis never crosses a
/// triangle, it never leaves the room and never comes nearer to anything than its radius.
TEST(CapsuleBody, NeverPenetratesAnythingInARandomMaze) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Rng rng(seed, "maze");
    SceneMesh mesh = BoxRoom(8, 2.6f, 8);
    for (int i = 0; i < 40; ++i) {
      const auto x = static_cast<float>(rng.Uniform(0.5, 7.0));
      const auto z = static_cast<float>(-rng.Uniform(0.5, 7.0));
      const auto w = static_cast<float>(rng.Uniform(0.01, 0.8));
      const auto h = static_cast<float>(rng.Uniform(0.05, 2.5));
      AddBox({x, 0, z}, {x + w, h, z + 0.02f}, kGrey, &mesh);
      AddQuad({x, 0, z}, {x + 0.3f, 0, z + w}, {x + 0.4f, h, z + w}, {x + 0.1f, h, z}, kGrey,
              &mesh);
    }
    const PhysicsWorld world(mesh);
    CapsuleBody body(world, {});
    for (bool placed = false; !placed;) {
      try {
        body.Reset({{rng.Uniform(0.5, 7.5), 0.0, -rng.Uniform(0.5, 7.5)}, 0.0});
        placed = true;
      } catch (const PoseError&) {
      }
    }
    float walked = 0.0f;
    for (int step = 0; step < 1500; ++step) {
      const Eigen::Vector3f before = body.pose().position.cast<float>();
      body.Move({rng.Uniform(0, 0.5), rng.Uniform(-0.1, 0.1), rng.Uniform(-0.6, 0.6)});
      const Eigen::Vector3f after = body.pose().position.cast<float>();
      ASSERT_TRUE(after.allFinite());
      ASSERT_GT(after.x(), 0.09f);
      ASSERT_LT(after.x(), 7.91f);
      ASSERT_LT(after.z(), -0.09f);
      ASSERT_GT(after.z(), -7.91f);
      const Capsule torso{after + Eigen::Vector3f(0, 0.3f, 0), 1.1f, 0.1f};
      const auto nearest = world.Nearest(torso, 0.1f - 0.0011f);
      ASSERT_FALSE(nearest.has_value()) << "step " << step << " at " << nearest->distance;
      walked += (after - before).norm();
    }
    EXPECT_GT(walked, 30.0f) << "the body should not get stuck for good";
  }
}

}  // namespace
}  // namespace bulletnav::sim
