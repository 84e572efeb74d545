// SPDX-License-Identifier: MIT
#include "benchmark/privileged/shortest_path.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"
#include "tests/support/trials.h"

namespace bulletnav::bench {
namespace {

struct Means {
  double success = 0.0;
  double spl = 0.0;
};

Means Try(const std::shared_ptr<const sim::World>& world, sim::NoiseMode noise, int trials,
          const ShortestPathAgent::Config& config) {
  sim::SimulatedBody body(world, {}, sim::NoiseModel(noise));
  ShortestPathAgent agent(config);
  sim::Rng rng(2, "trials");
  Means means;
  for (int i = 0; i < trials; ++i) {
    const tests::Trial trial = tests::DrawTrial(world, 1.5, 10.0, &rng);
    const auto result = tests::RunTrial(&body, {}, world, trial, &agent);
    EXPECT_TRUE(result.success() || noise != sim::NoiseMode::kNone)
        << world->name() << ": start " << trial.start.position.transpose() << ", goal "
        << trial.goal.position.transpose();
    means.success += result.success() ? 1.0 / trials : 0.0;
    means.spl += result.spl() / trials;
  }
  return means;
}

void ExpectCeiling(const std::shared_ptr<const sim::World>& world,
                   const ShortestPathAgent::Config& config = {}) {
  const Means quiet = Try(world, sim::NoiseMode::kNone, 60, config);
  EXPECT_NEAR(quiet.success, 1.0, 1e-9);
  EXPECT_GE(quiet.spl, 0.97);
  EXPECT_GE(Try(world, sim::NoiseMode::kAnsReleased, 60, config).success, 0.97);
}

TEST(ShortestPath, IsTheCeilingInRoomsAndCorridors) {
  ExpectCeiling(sim::World::FromMesh(tests::BoxRoom(8, 2.6f, 8), "room"));
  ExpectCeiling(sim::World::FromMesh(tests::LCorridor(8, 7, 1.2f, 2.6f), "corridor"));
}

TEST(ShortestPath, IsTheCeilingInHouses) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    ExpectCeiling(sim::World::FromMesh(tests::ShellHouse(seed), "house" + std::to_string(seed)));
  }
}

TEST(ShortestPath, IsTheCeilingInAFurnishedHouseMadeByOthers) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scene aws_small_house";
  const auto world = sim::World::Load(*file);
  ExpectCeiling(world);
  ExpectCeiling(world, {.search_pause = 25});  // as teachers do
}

TEST(ShortestPath, StopsWhereThereIsNoWay) {
  GroundTruth truth;
  truth.world = sim::World::FromMesh(tests::BoxRoom(4, 2.6f, 4), "room");
  truth.pose = {{2, 0, -2}, 0.0};
  truth.goal = {{40, 0, -2}, 0.0};
  ShortestPathAgent agent({});
  agent.Reset(truth);
  EXPECT_EQ(agent.Act(truth), sim::Action::kStop);
  EXPECT_FALSE(agent.Advise(truth).leads);
  truth.goal = {{2.3, 0, -2}, 0.0};
  EXPECT_EQ(agent.Advise(truth).action, sim::Action::kStop);
  EXPECT_TRUE(agent.Advise(truth).leads);
}

/// A room with a wall across it with gaps; the body does not fit into the narrower one, which the
/// navmesh's way takes.
GroundTruth BeforeAWall(const std::vector<std::pair<float, float>>& walls) {
  sim::SceneMesh mesh = tests::BoxRoom(6, 2.6f, 8);
  for (const auto& [from, to] : walls) {
    tests::AddBox({from, 0.0f, -4.05f}, {to, 2.6f, -3.95f}, {90, 90, 90}, &mesh);
  }
  GroundTruth truth;
  truth.world = sim::World::FromMesh(std::move(mesh), "gaps");
  truth.body.radius = 0.3f;
  truth.pose = {{3.1, 0, -3.7}, 0.0};
  truth.goal = {{3.1, 0, -7}, 0.0};
  return truth;
}

TEST(ShortestPath, ATeacherGivesUpAWayRoundThatTheBodyHasLeft) {
  GroundTruth truth = BeforeAWall({{0.0f, 2.9f}, {3.3f, 4.2f}, {5.4f, 6.0f}});
  const auto advice_beyond_the_wall = [&](const ShortestPathAgent::Config& config) {
    ShortestPathAgent agent(config);
    truth.pose = {{3.1, 0, -3.7}, 0.0};
    agent.Reset(truth);
    EXPECT_EQ(agent.Advise(truth).action, sim::Action::kTurnRight);  // to the wider gap
    truth.pose.position.z() = -5.0;
    return agent.Advise(truth).action;
  };
  EXPECT_EQ(advice_beyond_the_wall({.most_stray = 0.5}), sim::Action::kMoveForward);
  EXPECT_NE(advice_beyond_the_wall({}), sim::Action::kMoveForward);  // back to that way
}

TEST(ShortestPath, SaysThatPushingOnLeadsNowhereWhereThereIsNoWayRound) {
  GroundTruth truth = BeforeAWall({{0.0f, 2.9f}, {3.3f, 6.0f}});
  ShortestPathAgent agent({.search_pause = 3});
  agent.Reset(truth);
  for (int i = 0; i < 6; ++i) {
    const ShortestPathAgent::Advice advice = agent.Advise(truth);
    EXPECT_EQ(advice.action, sim::Action::kMoveForward);
    EXPECT_FALSE(advice.leads) << i;
  }
  truth.pose.yaw = 1.0;
  EXPECT_EQ(agent.Advise(truth).action, sim::Action::kTurnRight);
  EXPECT_TRUE(agent.Advise(truth).leads);
  truth.pose = {{3.1, 0, -1}, 0.0};  // where forward brings it nearer
  EXPECT_EQ(agent.Advise(truth).action, sim::Action::kMoveForward);
  EXPECT_TRUE(agent.Advise(truth).leads);
}

TEST(PrivilegedAgents, AreMadeByNameWithAConfig) {
  EXPECT_EQ(PrivilegedAgentNames(), std::vector<std::string>{"shortest_path"});
  EXPECT_EQ(MakePrivilegedAgent("metric_map_fbe"), nullptr);
  EXPECT_TRUE(MakePrivilegedAgent("shortest_path", sim::ParseYaml("stop_distance: 0.3", "c")));
  EXPECT_THROW(MakePrivilegedAgent("shortest_path", sim::ParseYaml("stop_distance: -1", "c")),
               sim::FileError);
  EXPECT_THROW(MakePrivilegedAgent("shortest_path", sim::ParseYaml("stop: 1", "c")),
               sim::FileError);
}

}  // namespace
}  // namespace bulletnav::bench
