// SPDX-License-Identifier: MIT
#include <array>
#include <map>

#include <gtest/gtest.h>

#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

std::map<sim::Action, int> Count(const std::string& config, int steps) {
  const auto agent =
      ConfigureAgent("random", sim::ParseYaml(config, "c"))(std::array<AgentContext, 1>{});
  agent->Reset(0, {}, 11);
  std::map<sim::Action, int> count;
  for (int i = 0; i < steps; ++i) {
    std::array action = {sim::Action::kStop};
    agent->Act(std::array{LaneObservation{0, {}}}, action);
    ++count[action[0]];
  }
  return count;
}

TEST(Random, DrawsActionsWithTheProbabilitiesOfItsConfig) {
  auto count = Count("{forward: 0.5, stop: 0.1}", 20'000);
  EXPECT_NEAR(count[sim::Action::kMoveForward], 10'000, 300);
  EXPECT_NEAR(count[sim::Action::kStop], 2'000, 150);
  EXPECT_NEAR(count[sim::Action::kTurnLeft], 4'000, 200);
  EXPECT_NEAR(count[sim::Action::kTurnRight], 4'000, 200);
}

TEST(Random, NeverDrawsWhatHasNoProbability) {
  auto count = Count("{forward: 1.0, stop: 0.0}", 1'000);
  EXPECT_EQ(count[sim::Action::kMoveForward], 1'000);
}

}  // namespace
}  // namespace bulletnav::agent
