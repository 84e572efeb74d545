// SPDX-License-Identifier: MIT
#include "sim/simulator.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::BoxRoom;

std::shared_ptr<const World> Room(const std::string& name = "room") {
  return World::FromMesh(BoxRoom(4, 2.6f, 6), name);
}

SimulatorSpec Small(NoiseMode noise) {
  SimulatorSpec spec;
  spec.panorama.rows = 16;
  spec.panorama.cols = 64;
  spec.noise = noise;
  return spec;
}

constexpr std::array kWalk = {Action::kMoveForward, Action::kTurnLeft,   Action::kMoveForward,
                              Action::kTurnRight,   Action::kTurnRight,  Action::kMoveForward,
                              Action::kStop,        Action::kMoveForward};

TEST(Simulator, WithoutNoiseStepsAndOdometryAreExact) {
  Simulator simulator(Room(), Small(NoiseMode::kNone));
  const Observation& first = simulator.Reset({{2, 0, -1}, 0.0});
  EXPECT_EQ(first.sensors.odometry.x, 0.0);
  EXPECT_EQ(first.color.size(), 16u * 64 * 3);
  const Observation& next = simulator.Step(Action::kMoveForward);
  EXPECT_NEAR(next.sensors.odometry.x, 0.25, 1e-6);
  EXPECT_NEAR(next.sensors.odometry.y, 0.0, 1e-6);
  EXPECT_NEAR(simulator.body().true_pose().position.z(), -1.25, 1e-6);
  simulator.Step(Action::kTurnLeft);
  EXPECT_NEAR(RadToDeg(next.sensors.odometry.yaw), 10.0, 1e-9);
  EXPECT_NEAR(RadToDeg(simulator.body().true_pose().yaw), 10.0, 1e-9);
  EXPECT_NEAR(simulator.body().path_length(), 0.25, 1e-6);
  EXPECT_EQ(simulator.body().steps(), 2);
}

TEST(Simulator, TheCameraLooksFromItsHeightAlongTheBodysHeading) {
  Simulator simulator(Room(), Small(NoiseMode::kNone));
  simulator.Reset({{2, 0, -1}, 0.3});
  const CameraPose camera = simulator.body().camera_pose();
  EXPECT_FLOAT_EQ(camera.position.y(), 1.25f);
  EXPECT_FLOAT_EQ(camera.yaw, 0.3f);
}

TEST(Simulator, OdometryDriftsFromTheTruthWithNoiseOnly) {
  for (const NoiseMode mode :
       {NoiseMode::kNone, NoiseMode::kAnsReleased, NoiseMode::kAnsRadians, NoiseMode::kPhysical}) {
    Simulator simulator(Room(), Small(mode));
    const BodyPose start{{2, 0, -1}, 0.0};
    simulator.Reset(start);
    PlanarPose estimate;
    for (const Action action : kWalk) {
      estimate = Compose(estimate, simulator.Step(action).sensors.odometry);
    }
    const PlanarPose truth = RelativePose(start, simulator.body().true_pose());
    const double drift = std::hypot(estimate.x - truth.x, estimate.y - truth.y);
    if (mode == NoiseMode::kNone) {
      EXPECT_LT(drift, 1e-6);
    } else {
      EXPECT_GT(drift, 1e-3);
      EXPECT_LT(drift, 0.3);
    }
  }
}

/// All that a walk produces, for comparison.
struct Trace {
  std::vector<Eigen::Vector3d> positions;
  std::vector<PlanarPose> odometry;
  std::vector<std::uint8_t> last_color;
};

Trace Walk(Simulator* simulator, const EpisodeKey& key) {
  Trace trace;
  simulator->Reset({{2, 0, -1}, 0.2}, key);
  for (const Action action : kWalk) {
    const Observation& o = simulator->Step(action);
    trace.odometry.push_back(o.sensors.odometry);
    trace.positions.push_back(simulator->body().true_pose().position);
    trace.last_color = o.color;
  }
  return trace;
}

bool Same(const Trace& a, const Trace& b) {
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    if (a.positions[i] != b.positions[i] || a.odometry[i].x != b.odometry[i].x) return false;
  }
  return a.last_color == b.last_color;
}

TEST(Simulator, TheSameKeyGivesTheSameEpisodeWhateverCameBefore) {
  Simulator fresh(Room(), Small(NoiseMode::kAnsReleased));
  Simulator used(Room(), Small(NoiseMode::kAnsReleased));
  Walk(&used, {7, 1});
  EXPECT_TRUE(Same(Walk(&fresh, {7, 2}), Walk(&used, {7, 2})));
}

TEST(Simulator, AnotherSeedEpisodeOrSceneGivesOtherNoise) {
  Simulator a(Room(), Small(NoiseMode::kAnsReleased));
  Simulator b(Room("another room"), Small(NoiseMode::kAnsReleased));
  const Trace reference = Walk(&a, {7, 2});
  EXPECT_FALSE(Same(reference, Walk(&a, {8, 2})));
  EXPECT_FALSE(Same(reference, Walk(&a, {7, 3})));
  EXPECT_FALSE(Same(reference, Walk(&b, {7, 2})));
}

TEST(Simulator, BumpsAreSensedAndCounted) {
  Simulator simulator(Room(), Small(NoiseMode::kNone));
  simulator.Reset({{2, 0, -5.8}, 0.0});
  EXPECT_TRUE(simulator.Step(Action::kMoveForward).sensors.collided);
  EXPECT_FALSE(simulator.Step(Action::kTurnLeft).sensors.collided);
  EXPECT_EQ(simulator.body().collisions(), 1);
  EXPECT_LT(simulator.body().path_length(), 0.12);
}

TEST(Simulator, ABadResetChangesNothing) {
  Simulator simulator(Room(), Small(NoiseMode::kNone));
  simulator.Reset({{2, 0, -1}, 0.0});
  simulator.Step(Action::kMoveForward);
  EXPECT_THROW(simulator.Reset({{9, 0, -1}, 0.0}), PoseError);
  EXPECT_EQ(simulator.body().steps(), 1);
  EXPECT_NEAR(simulator.body().true_pose().position.z(), -1.25, 1e-6);
}

TEST(Simulator, WhatIsNotWantedIsNotMade) {
  SimulatorSpec spec = Small(NoiseMode::kNone);
  spec.depth = false;
  Simulator simulator(Room(), spec);
  const Observation& o = simulator.Reset({{2, 0, -1}, 0.0});
  EXPECT_FALSE(o.color.empty());
  EXPECT_TRUE(o.depth.empty());
}

TEST(World, SaysWhenThereIsNoFloor) {
  SceneMesh mesh;
  tests::AddQuad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {9, 9, 9}, &mesh);
  const auto world = World::FromMesh(mesh, "wall.obj");
  try {
    world->RequireFloor();
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("--ground-plane"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("wall.obj"), std::string::npos);
  }
  EXPECT_NO_THROW(Room()->RequireFloor());
}

/// What the call throws as Error, or nothing.
template <class Call>
std::string ErrorOf(const Call& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(Simulator, MisuseThrowsAndNamesTheCall) {
  using testing::StartsWith;
  EXPECT_THAT(ErrorOf([] {
                Simulator(nullptr, {});
              }),
              StartsWith("Simulator: the world is null"));
  EXPECT_THAT(ErrorOf([] {
                SimulatedBody(nullptr, {}, NoiseModel(NoiseMode::kNone));
              }),
              StartsWith("SimulatedBody: the world is null"));
  Simulator simulator(Room(), Small(NoiseMode::kNone));
  EXPECT_THAT(ErrorOf([&] {
                simulator.Step(Action::kMoveForward);
              }),
              StartsWith("Simulator::Step: call Reset first"));
  EXPECT_THAT(ErrorOf([&] {
                simulator.body().camera_pose();
              }),
              StartsWith("SimulatedBody::camera_pose: "));
  SimulatorSpec bad = Small(NoiseMode::kNone);
  bad.panorama.rows = -1;
  EXPECT_THROW(Simulator(Room(), bad), Error);
  // A place that is none leaves the simulator as it was: not yet reset, then where it stood.
  const double nan = std::nan("");
  EXPECT_THROW(simulator.Reset({{2, nan, -1}, 0.0}), PoseError);
  EXPECT_THROW(simulator.Step(Action::kMoveForward), Error);
  simulator.Reset({{2, 0, -1}, 0.0});
  EXPECT_THROW(simulator.Reset({{2, 0, -1}, nan}), PoseError);
  EXPECT_THAT(ErrorOf([&] {
                simulator.Step(static_cast<Action>(17));
              }),
              StartsWith("Simulator::Step: 17 is no action"));
  EXPECT_EQ(simulator.body().steps(), 0);
  EXPECT_EQ(simulator.body().true_pose().position.x(), 2.0);
}

TEST(World, MeshesThatDoNotFitTogetherAreRefused) {
  SceneMesh mesh = tests::BoxRoom(4, 2.6f, 3);
  mesh.uvs.clear();
  EXPECT_THROW(World::FromMesh(mesh, "room"), Error);
  EXPECT_THROW(World::FromMesh({}, "room"), Error);
}

}  // namespace
}  // namespace bulletnav::sim
