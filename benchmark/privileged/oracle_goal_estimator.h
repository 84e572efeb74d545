// SPDX-License-Identifier: MIT
#pragma once
#include "agent/models/goal_estimator.h"
#include "benchmark/play/ground_truth.h"

namespace bulletnav::bench {

/// Recognises the goal from the ground truth instead of the panoramas: what the learned functions
/// would say if they never erred. Rows of agents that use it say "oracle".
/// The goal is seen when IsInNode says so.
class OracleGoalEstimator final : public agent::GoalEstimator {
 public:
  /// `truth` must outlive the estimator and be up to date at every call.
  explicit OracleGoalEstimator(const GroundTruth& truth) : truth_(truth) {}

  std::optional<agent::RelativeGoal> Estimate(const agent::Panorama& here,
                                              const agent::Panorama& goal) override;

 private:
  const GroundTruth& truth_;
};

}  // namespace bulletnav::bench
