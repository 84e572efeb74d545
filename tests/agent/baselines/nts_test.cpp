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

class NtsTest : public testing::TestWithParam<const char*> {};

TEST_P(NtsTest, WalksStraightToAGoalThatItSees) {
  const auto world = sim::World::FromMesh(tests::BoxRoom(6, 2.6f, 6), "room");
  sim::Simulator simulator(world, Quiet());
  sim::Rng rng(4, "goals");
  for (int i = 0; i < 3; ++i) {
    const tests::Trial trial = tests::DrawTrial(world, 1.5, 2.9, &rng);
    const tests::TrialResult result =
        tests::RunTrial(&simulator, trial, ConfigureAgent(GetParam()));
    EXPECT_TRUE(result.success());
    EXPECT_GT(result.spl(), 0.95);
    EXPECT_LT(result.distance_left, 0.75);
  }
}

TEST_P(NtsTest, FindsAGoalRoundTheCorner) {
  const auto world = sim::World::FromMesh(tests::LCorridor(8, 7, 1.5f, 2.6f), "corridor");
  sim::Simulator simulator(world, Quiet());
  const tests::Trial trial{{{1, 0, -0.7}, 1.0}, {{7.2, 0, -6}, 0.0}, 11.6, {}};
  const tests::TrialResult result = tests::RunTrial(&simulator, trial, ConfigureAgent(GetParam()));
  EXPECT_TRUE(result.success());
  EXPECT_GT(result.spl(), 0.8);
}

INSTANTIATE_TEST_SUITE_P(Agents, NtsTest,
                         testing::Values("nts", "nts_paper", "nts_without_graph",
                                         "nts_without_score"));

}  // namespace
}  // namespace bulletnav::agent
