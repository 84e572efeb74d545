// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "agent/models/semantic_model.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/privileged/oracle_goal_estimator.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// The four functions of Neural Topological SLAM answered from the ground truth: what the learned
/// model would say if it never erred. Rows of agents that use it say "oracle".
/// A code holds where a panorama was taken: at the goal if it lies where GroundTruth::goal_panorama
/// does, else where the body is now. Labels: appendix B of the paper, with the navmesh for the map
/// of the source's depth. A pair of one node gets direction (shared between the two nearest, so
/// that it is exact) and distance, any other pair scores; the rest is 0. One lane's; not for
/// several threads. Cost: some milliseconds for a pair that needs scores.
class OracleSemanticModel final : public agent::SemanticModel, public agent::GoalEstimator {
 public:
  /// `truth` must outlive the model and be up to date at every Encode.
  explicit OracleSemanticModel(const GroundTruth& truth) : truth_(truth), estimator_(truth) {}

  std::vector<agent::PanoramaCode> Encode(std::span<const agent::Panorama> panoramas) override;
  std::array<float, agent::kDirections> Explorable(const agent::PanoramaCode& source) override;
  std::vector<agent::PairPrediction> Compare(std::span<const agent::PanoramaCode* const> sources,
                                             const agent::PanoramaCode& goal) override;

  /// As OracleGoalEstimator.
  std::optional<agent::RelativeGoal> Estimate(const agent::Panorama& here,
                                              const agent::Panorama& goal) override {
    return estimator_.Estimate(here, goal);
  }

 private:
  agent::PairPrediction ComparePair(const sim::BodyPose& source, const sim::BodyPose& goal);
  /// The farthest place in a direction, up to 3 m, that the way to is hardly longer than straight.
  Eigen::Vector3f FarthestFree(const sim::BodyPose& source, int direction);
  bool IsFree(const sim::BodyPose& source, const Eigen::Vector3f& place, double straight);
  const sim::NavmeshQuery& query();

  const GroundTruth& truth_;
  OracleGoalEstimator estimator_;
  std::shared_ptr<const sim::World> world_;
  std::optional<sim::NavmeshQuery> query_;
};

}  // namespace bulletnav::bench
