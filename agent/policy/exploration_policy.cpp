// SPDX-License-Identifier: MIT
#include "agent/policy/exploration_policy.h"

#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

int StepsOf(double number) {
  constexpr double kMost = kMostGoalSteps;
  return static_cast<int>(std::clamp(std::nearbyint(number / kGoalStep), -kMost, kMost));
}

}  // namespace

GoalSteps DrawGoal(const GoalDistribution& goal, sim::Rng* rng) {
  GoalSteps steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = StepsOf(goal.mean[i] + goal.deviation[i] * rng->Normal());
  }
  return steps;
}

std::array<double, 2> SharesOf(const GoalSteps& steps) {
  std::array<double, 2> shares = {};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    shares[i] = 1.0 / (1.0 + sim::Exp(-kGoalStep * steps[i]));
  }
  return shares;
}

GoalSteps DrawAnyGoal(sim::Rng* rng) {
  GoalSteps steps;
  for (int& step : steps) {
    const double share = rng->Uniform(0.001, 0.999);
    step = StepsOf(sim::Log(share / (1.0 - share)));
  }
  return steps;
}

}  // namespace bulletnav::agent
