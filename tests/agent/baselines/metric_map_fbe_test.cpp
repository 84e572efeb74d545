// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/trials.h"

namespace bulletnav::agent {
namespace {

sim::SimulatorSpec Quiet() {
  sim::SimulatorSpec spec;
  spec.noise = sim::NoiseMode::kNone;
  spec.color = false;
  return spec;
}

TEST(MetricMapFbe, WalksStraightToAGoalThatItSees) {
  const auto world = sim::World::FromMesh(tests::BoxRoom(6, 2.6f, 6), "room");
  sim::Simulator simulator(world, Quiet());
  const auto maker = ConfigureAgent("metric_map_fbe");
  sim::Rng rng(4, "goals");
  for (int i = 0; i < 5; ++i) {
    const tests::Trial trial = tests::DrawTrial(world, 1.5, 2.9, &rng);
    const tests::TrialResult result = tests::RunTrial(&simulator, trial, maker);
    EXPECT_TRUE(result.success());
    EXPECT_GT(result.spl(), 0.95) << i;
    EXPECT_LT(result.distance_left, 0.6);
    EXPECT_EQ(result.collisions, 0);
  }
}

TEST(MetricMapFbe, FindsAGoalRoundTheCorner) {
  const auto world = sim::World::FromMesh(tests::LCorridor(8, 7, 1.5f, 2.6f), "corridor");
  sim::Simulator simulator(world, Quiet());
  const tests::Trial trial{{{1, 0, -0.7}, 1.0}, {{7.2, 0, -6}, 0.0}, 11.6, {}};
  const tests::TrialResult result =
      tests::RunTrial(&simulator, trial, ConfigureAgent("metric_map_fbe"));
  EXPECT_TRUE(result.success());
  EXPECT_GT(result.spl(), 0.9);
}

TEST(MetricMapFbe, StopsAtTheDistanceOfItsConfig) {
  const auto world = sim::World::FromMesh(tests::BoxRoom(6, 2.6f, 6), "room");
  sim::Simulator simulator(world, Quiet());
  const tests::Trial trial{{{1, 0, -1}, 0.0}, {{1, 0, -3.5}, 0.0}, 2.5, {}};
  const auto config = sim::ParseYaml("stop_distance: 1.3", "c.yaml");
  const auto result = tests::RunTrial(&simulator, trial, ConfigureAgent("metric_map_fbe", config));
  EXPECT_TRUE(result.stopped);
  EXPECT_NEAR(result.distance_left, 1.25, 0.1);
  EXPECT_FALSE(result.success());
}

TEST(MetricMapFbe, GoesOnExploringWhereThereIsNothingLeftToExplore) {
  // The goal is in a closed room beside.
  sim::SceneMesh mesh = tests::BoxRoom(3, 2.6f, 3);
  const auto world = sim::World::FromMesh(mesh, "cell");
  sim::Simulator simulator(world, Quiet());
  const tests::Trial trial{{{1, 0, -1}, 0.0}, {{50, 0, -3.5}, 0.0}, 2.5, {}};
  const auto result = tests::RunTrial(&simulator, trial, ConfigureAgent("metric_map_fbe"));
  EXPECT_FALSE(result.stopped);
  EXPECT_EQ(result.steps, 500);
}

}  // namespace
}  // namespace bulletnav::agent
