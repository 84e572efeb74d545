// SPDX-License-Identifier: MIT
#include "tests/support/houses.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/trials.h"

namespace bulletnav::agent {
namespace {

struct Sums {
  double success = 0.0;
  double spl = 0.0;
};

/// Means over some trials.
Sums Try(const std::shared_ptr<const sim::World>& world, const std::string& name,
         sim::NoiseMode noise, int trials) {
  sim::SimulatorSpec spec;
  spec.noise = noise;
  spec.color = false;
  sim::Simulator simulator(world, spec);
  sim::Rng rng(9, "houses");
  const AgentMaker maker = ConfigureAgent(name);
  Sums sums;
  for (int i = 0; i < trials; ++i) {
    const auto result = tests::RunTrial(&simulator, tests::DrawTrial(world, 3, 5, &rng), maker);
    sums.success += result.success() ? 1.0 / trials : 0.0;
    sums.spl += result.spl() / trials;
  }
  return sums;
}

std::shared_ptr<const sim::World> House() {
  return sim::World::FromMesh(tests::ShellHouse(3), "house");
}

TEST(Houses, MetricMapFbeFindsMostGoalsInAnEmptyHouse) {
  const Sums quiet = Try(House(), "metric_map_fbe", sim::NoiseMode::kNone, 12);
  EXPECT_GT(quiet.success, 0.9);
  EXPECT_GT(quiet.spl, 0.4);
  EXPECT_GT(Try(House(), "metric_map_fbe", sim::NoiseMode::kAnsReleased, 12).success, 0.7);
}

TEST(Houses, MetricMapFbeFindsGoalsInAFurnishedHouseMadeByOthers) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scene aws_small_house";
  EXPECT_GT(Try(sim::World::Load(*file), "metric_map_fbe", sim::NoiseMode::kNone, 12).success, 0.6);
}

TEST(Houses, RandomFindsNextToNothing) {
  EXPECT_LT(Try(House(), "random", sim::NoiseMode::kAnsReleased, 12).success, 0.2);
}

}  // namespace
}  // namespace bulletnav::agent
