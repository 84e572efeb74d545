// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "agent/models/goal_estimator.h"
#include "agent/models/semantic_model.h"

namespace bulletnav::agent {

/// Recognises the goal by F_L and places it by F_R of a semantic model.
class ModelGoalEstimator final : public GoalEstimator {
 public:
  /// `certainty`: the probability of one node from which the goal is taken to be seen.
  ModelGoalEstimator(std::shared_ptr<SemanticModel> model, double certainty)
      : model_(std::move(model)), certainty_(certainty) {}

  std::optional<RelativeGoal> Estimate(const Panorama& here, const Panorama& goal) override;

 private:
  bool IsKnown(const Panorama& goal) const;

  std::shared_ptr<SemanticModel> model_;
  double certainty_;
  // The goal last asked for: it is encoded once.
  std::vector<std::uint8_t> color_;
  std::vector<float> depth_;
  PanoramaCode goal_;
};

}  // namespace bulletnav::agent
