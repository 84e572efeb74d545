// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "agent/models/model.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Where an exploration policy would go: two normal numbers, whose sigmoids are shares of the goal
/// window's sides (see GoalAt), along x and along y of the agent's plane.
struct GoalDistribution {
  std::array<double, 2> mean = {};
  std::array<double, 2> deviation = {1.0, 1.0};
};

/// Drawn goals are whole steps of such a number.
inline constexpr double kGoalStep = 1.0 / 256;
inline constexpr int kMostGoalSteps = 4095;  // of either sign: within 16
using GoalSteps = std::array<int, 2>;
GoalSteps DrawGoal(const GoalDistribution& goal, sim::Rng* rng);
/// Shares of the window's sides.
std::array<double, 2> SharesOf(const GoalSteps& steps);
/// A goal that is as likely anywhere in the window.
GoalSteps DrawAnyGoal(sim::Rng* rng);

/// The global policy of Active Neural SLAM: chooses long-term goals by what is mapped.
/// Deterministic. Source: Chaplot et al., "Learning to explore using Active Neural SLAM", 2020.
class ExplorationPolicy : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "exploration policy";

  /// `view`: see WriteExplorationView. `heading`: see HeadingBin.
  virtual GoalDistribution Ask(std::span<const std::uint8_t> view, int heading) = 0;
};

}  // namespace bulletnav::agent
