// SPDX-License-Identifier: MIT
#include "sim/batch_simulator.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::BoxRoom;

constexpr int kLanes = 5;
constexpr int kSteps = 12;

SimulatorSpec Small() {
  SimulatorSpec spec;
  spec.panorama.rows = 16;
  spec.panorama.cols = 64;
  return spec;
}

/// Lanes 0 to 2 share one world, 3 and 4 another.
std::vector<std::shared_ptr<const World>> Worlds(Backend backend) {
  WorldOptions options;
  options.backend = backend;
  const auto a = World::FromMesh(BoxRoom(4, 2.6f, 6), "a", options);
  const auto b = World::FromMesh(BoxRoom(3, 2.4f, 3), "b", options);
  return {a, a, a, b, b};
}

BodyPose Start(int lane) {
  return {{1.0 + 0.2 * lane, 0, -1.5}, 0.4 * lane};
}
EpisodeKey Key(int lane) {
  return {3, static_cast<std::uint64_t>(lane)};
}
Action Choice(int lane, int step) {
  return kAllActions[static_cast<std::size_t>(1 + (lane + step * step) % 3)];
}

struct Result {
  std::vector<std::uint8_t> color;
  std::vector<float> depth;
  std::vector<Sensors> sensors = std::vector<Sensors>(kLanes);
};

/// Everything every lane saw, step by step.
std::vector<Result> RunBatch(int workers, Backend backend) {
  const SimulatorSpec spec = Small();
  BatchSimulator batch(Worlds(backend), spec, workers);
  for (int lane = 0; lane < kLanes; ++lane) batch.Reset(lane, Start(lane), Key(lane));
  std::vector<Result> results;
  for (int step = 0; step < kSteps; ++step) {
    if (step == 6) batch.Reset(1, Start(4), Key(9));  // lanes start over independently
    Result r;
    r.color.resize(3 * spec.panorama.pixels() * kLanes);
    r.depth.resize(spec.panorama.pixels() * kLanes);
    std::vector<Action> actions;
    for (int lane = 0; lane < kLanes; ++lane) actions.push_back(Choice(lane, step));
    batch.Step(actions, r.sensors, {r.color, r.depth});
    results.push_back(std::move(r));
  }
  return results;
}

class BatchSimulatorTest : public testing::TestWithParam<Backend> {};

TEST_P(BatchSimulatorTest, EveryLaneIsASimulatorOfItsOwn) {
  const SimulatorSpec spec = Small();
  const std::vector<Result> batch = RunBatch(2, GetParam());
  const auto worlds = Worlds(GetParam());
  const std::size_t pixels = spec.panorama.pixels();
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    Simulator single(worlds[l], spec);
    single.Reset(Start(lane), Key(lane));
    for (int step = 0; step < kSteps; ++step) {
      if (step == 6 && lane == 1) single.Reset(Start(4), Key(9));
      const Observation& o = single.Step(Choice(lane, step));
      const Result& r = batch[static_cast<std::size_t>(step)];
      EXPECT_TRUE(
          std::equal(o.color.begin(), o.color.end(), r.color.begin() + long(3 * pixels * l)));
      EXPECT_TRUE(std::equal(o.depth.begin(), o.depth.end(), r.depth.begin() + long(pixels * l)));
      EXPECT_EQ(o.sensors.odometry.x, r.sensors[l].odometry.x);
      EXPECT_EQ(o.sensors.odometry.yaw, r.sensors[l].odometry.yaw);
      EXPECT_EQ(o.sensors.collided, r.sensors[l].collided);
    }
  }
}

TEST_P(BatchSimulatorTest, TheNumberOfWorkersDoesNotMatter) {
  const std::vector<Result> one = RunBatch(1, GetParam());
  for (const int workers : {2, 3, 8}) {
    const std::vector<Result> many = RunBatch(workers, GetParam());
    for (std::size_t step = 0; step < one.size(); ++step) {
      EXPECT_EQ(one[step].color, many[step].color) << workers;
      EXPECT_EQ(one[step].depth, many[step].depth) << workers;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, BatchSimulatorTest,
                         testing::Values(Backend::kEmbree, Backend::kEgl), [](const auto& backend) {
                           return backend.param == Backend::kEgl ? "egl" : "embree";
                         });

TEST(BatchSimulator, LanesMoveToOtherWorlds) {
  const auto worlds = Worlds(Backend::kEmbree);
  BatchSimulator batch({worlds[0], worlds[0]}, Small(), 1);
  batch.SetWorld(0, worlds[3]);
  batch.SetWorld(1, worlds[3]);
  EXPECT_EQ(batch.body(0).world().name(), "b");
  batch.Reset(0, {{1, 0, -1}, 0.0});
  batch.Reset(1, {{2, 0, -1}, 0.0});
  std::vector<float> depth(2 * Small().panorama.pixels());
  batch.Observe({{}, depth});
  EXPECT_GT(depth.front(), 0.0f);
  EXPECT_LT(depth.front(), 3.0f);
}

TEST(BatchSimulator, TellsOfEachBodyThatHasMoved) {
  BatchSimulator batch(Worlds(Backend::kEmbree), Small(), 2);
  for (int lane = 0; lane < kLanes; ++lane) batch.Reset(lane, Start(lane), Key(lane));
  const std::vector<int> lanes = {1, 4};
  const std::vector<Action> actions(2, Action::kMoveForward);
  std::vector<Sensors> sensors(2);
  std::vector<double> told(2);
  batch.Step(lanes, actions, sensors, {}, [&](std::size_t place, const Sensors& sensed) {
    told[place] = sensed.odometry.x;
    EXPECT_NE(batch.body(lanes[place]).true_pose().position, Start(lanes[place]).position);
  });
  EXPECT_GT(told[0], 0.0);
  EXPECT_EQ(told, (std::vector{sensors[0].odometry.x, sensors[1].odometry.x}));
}

TEST(BatchSimulator, ABadResetNamesThePlaceAndKeepsTheLane) {
  BatchSimulator batch(Worlds(Backend::kEmbree), Small(), 1);
  batch.Reset(0, Start(0));
  EXPECT_THROW(batch.Reset(0, {{50, 0, 0}, 0.0}), PoseError);
  EXPECT_EQ(batch.body(0).true_pose().position.x(), Start(0).position.x());
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

TEST(BatchSimulator, MisuseThrowsNamesTheCallAndMovesNothing) {
  using testing::StartsWith;
  const auto worlds = Worlds(Backend::kEmbree);
  EXPECT_THAT(ErrorOf([] {
                BatchSimulator({nullptr}, Small(), 1);
              }),
              StartsWith("BatchSimulator: the world is null"));
  BatchSimulator batch({worlds[0], worlds[0]}, Small(), 1);
  batch.Reset(0, Start(0));
  std::vector<float> depth(2 * Small().panorama.pixels());
  EXPECT_THAT(ErrorOf([&] {
                batch.SetWorld(2, worlds[3]);
              }),
              StartsWith("BatchSimulator::SetWorld: there is no lane 2; there are 2"));
  EXPECT_THAT(ErrorOf([&] {
                batch.SetWorld(-1, worlds[3]);
              }),
              StartsWith("BatchSimulator::SetWorld: there is no lane -1"));
  EXPECT_THAT(ErrorOf([&] {
                batch.SetWorld(0, nullptr);
              }),
              StartsWith("BatchSimulator::SetWorld: the world is null"));
  EXPECT_EQ(batch.body(0).world().name(), "a");
  EXPECT_THAT(ErrorOf([&] {
                batch.Reset(2, Start(0));
              }),
              StartsWith("BatchSimulator::Reset: there is no lane 2"));
  EXPECT_THAT(ErrorOf([&] {
                batch.body(2);
              }),
              StartsWith("BatchSimulator::body: there is no"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Observe({{}, depth});
              }),
              StartsWith("BatchSimulator::Observe: lane 1 stands nowhere yet"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Render(3, {}, {{}, depth});
              }),
              StartsWith("BatchSimulator::Render: there is no lane 3"));
}

TEST(BatchSimulator, StepsThatDoNotFitMoveNothing) {
  using testing::StartsWith;
  const auto worlds = Worlds(Backend::kEmbree);
  BatchSimulator batch({worlds[0], worlds[0]}, Small(), 1);
  std::array actions = {Action::kMoveForward, Action::kMoveForward};
  std::array<Sensors, 2> sensors;
  std::vector<float> depth(2 * Small().panorama.pixels());
  batch.Reset(0, Start(0));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(actions, sensors, {});
              }),
              StartsWith("BatchSimulator::Step: lane 1 stands nowhere yet"));
  batch.Reset(1, Start(1));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(std::span(actions).first(1), sensors, {});
              }),
              StartsWith("BatchSimulator::Step: got 1 actions, 2 fit"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(actions, std::span(sensors).first(1), {});
              }),
              StartsWith("BatchSimulator::Step: got 1 sensors, 2 fit"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(actions, sensors, {{}, std::span(depth).first(5)});
              }),
              StartsWith("BatchSimulator::Step: got 5 values for depth, 0 or 2048 fit"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(std::array{1, 0}, actions, sensors, {});
              }),
              StartsWith("BatchSimulator::Step: lanes must rise"));
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(std::array{0, 0}, actions, sensors, {});
              }),
              StartsWith("BatchSimulator::Step: lanes must rise"));
  actions[1] = static_cast<Action>(-3);
  EXPECT_THAT(ErrorOf([&] {
                batch.Step(actions, sensors, {});
              }),
              StartsWith("BatchSimulator::Step: -3 is no action"));
  EXPECT_EQ(batch.body(0).steps(), 0);
  const CameraPose nowhere{{0, std::nanf(""), 0}, 0.0f};
  EXPECT_THAT(ErrorOf([&] {
                batch.Render(0, nowhere, {{}, std::span(depth).first(1024)});
              }),
              StartsWith("Render: "));
}

}  // namespace
}  // namespace bulletnav::sim
