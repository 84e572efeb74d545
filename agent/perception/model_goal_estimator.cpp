// SPDX-License-Identifier: MIT
#include "agent/perception/model_goal_estimator.h"

#include <algorithm>
#include <array>

#include "agent/perception/relative_pose.h"

namespace bulletnav::agent {

std::optional<RelativeGoal> ModelGoalEstimator::Estimate(const Panorama& here,
                                                         const Panorama& goal) {
  if (!IsKnown(goal)) {
    color_.assign(goal.color.begin(), goal.color.end());
    depth_.assign(goal.depth.begin(), goal.depth.end());
    goal_ = model_->Encode({&goal, 1}).front();
  }
  const PanoramaCode code = model_->Encode({&here, 1}).front();
  const std::array<const PanoramaCode*, 1> source = {&code};
  const PairPrediction seen = model_->Compare(source, goal_).front();
  if (seen.same_node < certainty_) return std::nullopt;
  return RelativePoseOf(seen);
}

bool ModelGoalEstimator::IsKnown(const Panorama& goal) const {
  return !goal_.empty() && std::ranges::equal(goal.color, color_) &&
         std::ranges::equal(goal.depth, depth_);
}

}  // namespace bulletnav::agent
