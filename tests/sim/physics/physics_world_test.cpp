// SPDX-License-Identifier: MIT
#include "sim/physics/physics_world.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using tests::AddQuad;
using tests::BoxRoom;
using Vec = Eigen::Vector3f;

TEST(PhysicsWorld, RaysMeetTheWallsOfABoxRoomWhereTheyStand) {
  const PhysicsWorld world(BoxRoom(4, 2.6f, 6));
  const Vec eye(1, 1.25f, -2);
  const std::pair<Vec, float> rays[] = {{{10, 0, 0}, 3.0f},  {{-10, 0, 0}, 1.0f},
                                        {{0, 0, -10}, 4.0f}, {{0, 0, 10}, 2.0f},
                                        {{0, 10, 0}, 1.35f}, {{0, -10, 0}, 1.25f}};
  for (const auto& [ray, distance] : rays) {
    const auto hit = world.RayTest(eye, eye + ray);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction * 10.0f, distance, 1e-4f);
  }
  EXPECT_FALSE(world.RayTest(eye, eye + Vec(0.5f, 0, 0)));
}

TEST(PhysicsWorld, SweepStopsARadiusFromTheWallWithItsNormal) {
  const PhysicsWorld world(BoxRoom(4, 2.6f, 6));
  const Capsule capsule{{2, 0.3f, -3}, 1.1f, 0.1f};
  const auto hit = world.Sweep(capsule, Vec(3, 0, 0));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->fraction * 3.0f, 1.9f, 2e-3f);
  EXPECT_NEAR(hit->normal.x(), -1.0f, 1e-3f);
  EXPECT_FALSE(world.Sweep(capsule, Vec(1.8f, 0, 0)));
}

TEST(PhysicsWorld, SweepAgreesWithTheExactDistanceInRandomDirections) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({1, 0, -4}, {1.5f, 1.0f, -3.2f}, {9, 9, 9}, &mesh);
  const PhysicsWorld world(mesh);
  Rng rng(5, "sweep");
  for (int i = 0; i < 500; ++i) {
    const Capsule capsule{{static_cast<float>(rng.Uniform(1.8, 3.6)), 0.3f,
                           static_cast<float>(-rng.Uniform(0.4, 5.6))},
                          1.1f,
                          0.1f};
    const double angle = rng.Uniform(0, 6.28);
    const Vec motion(static_cast<float>(3 * std::cos(angle)), 0,
                     static_cast<float>(3 * std::sin(angle)));
    const auto hit = world.Sweep(capsule, motion);
    if (!hit) continue;
    Capsule stopped = capsule;
    stopped.low += hit->fraction * motion;
    const auto nearest = world.Nearest(stopped, 0.2f);
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(nearest->distance, 0.1f, 2e-3f) << i;
  }
}

TEST(PhysicsWorld, AxisCrossesExactlyWhatStandsBetween) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddQuad({0, 0, -3}, {2, 0, -3}, {2, 2, -3}, {0, 2, -3}, {9, 9, 9}, &mesh);
  const PhysicsWorld world(mesh);
  const Capsule capsule{{1, 0.3f, -2}, 1.1f, 0.1f};
  EXPECT_TRUE(world.AxisCrosses(capsule, Vec(0, 0, -2)));
  EXPECT_FALSE(world.AxisCrosses(capsule, Vec(0, 0, -0.9f)));
  const Capsule beside{{2.5f, 0.3f, -2}, 1.1f, 0.1f};
  EXPECT_FALSE(world.AxisCrosses(beside, Vec(0, 0, -2)));
}

TEST(PhysicsWorld, ManyThreadsGetTheSameAnswers) {
  const PhysicsWorld world(BoxRoom(4, 2.6f, 6));
  const auto walk = [&world] {
    Rng rng(1, "threads");
    std::vector<float> answers;
    for (int i = 0; i < 2000; ++i) {
      const Capsule capsule{{2, 0.3f, -3}, 1.1f, 0.1f};
      const Vec motion(static_cast<float>(rng.Uniform(-4, 4)), 0,
                       static_cast<float>(rng.Uniform(-4, 4)));
      const auto hit = world.Sweep(capsule, motion);
      answers.push_back(hit ? hit->fraction : 1.0f);
    }
    return answers;
  };
  std::vector<float> a;
  std::vector<float> b;
  std::thread first([&] {
    a = walk();
  });
  std::thread second([&] {
    b = walk();
  });
  first.join();
  second.join();
  EXPECT_EQ(a, b);
}

TEST(PhysicsWorld, AnEmptyMeshIsRefused) {
  EXPECT_THROW(PhysicsWorld(SceneMesh{}), Error);
}

}  // namespace
}  // namespace bulletnav::sim
