// SPDX-License-Identifier: MIT
#include "agent/metric_map/metric_map_agent.h"

#include "agent/models/free_space_model.h"
#include "agent/models/usual_slots.h"
#include "agent/perception/model_goal_estimator.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// A model that estimates goals by itself, as oracles do, is taken at its word.
std::shared_ptr<GoalEstimator> EstimatorOf(double goal_seen, const Models& models) {
  if (auto estimator = models.Find<GoalEstimator>(kSemanticModel)) return estimator;
  return std::make_shared<ModelGoalEstimator>(models.Need<SemanticModel>(kSemanticModel),
                                              goal_seen);
}

}  // namespace

void MetricMapAgentSpec::Validate() const {
  if (!(goal_seen >= 0.0 && goal_seen <= 1.0)) throw sim::Error("goal_seen must be in [0, 1]");
  if (sightings < 1) throw sim::Error("sightings must be at least 1");
  if (!(stop_certainty > 0.0 && stop_certainty < 1.0)) {
    throw sim::Error("stop_certainty must lie between 0 and 1");
  }
  if (!(stop_distance > 0.0)) throw sim::Error("stop_distance must be positive");
}

MetricMapAgent::MetricMapAgent(std::string_view name, const MetricMapAgentSpec& spec,
                               const AgentContext& context)
    : name_(name),
      navigator_(context.rig, spec.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
      estimator_(EstimatorOf(spec.goal_seen, context.models)),
      rng_(0, name),
      approach_(ApproachOf(spec)) {}

void MetricMapAgent::Reset(const Panorama& goal, std::uint64_t seed) {
  navigator_.Reset();
  NextGoal(goal, seed);
}

void MetricMapAgent::NextGoal(const Panorama& goal, std::uint64_t seed) {
  goal_ = goal;
  rng_ = sim::Rng(seed, name_);
  approach_.Reset();
  target_.reset();
  Forget();
}

sim::Action MetricMapAgent::Act(const Observation& observation) {
  navigator_.Observe(observation);
  approach_.See(estimator_->Estimate(observation.panorama, goal_), navigator_);
  target_ = approach_.target();
  std::optional<sim::Action> action = approach_.Act(&navigator_);
  if (!action) action = Explore();
  navigator_.Took(*action);
  return *action;
}

Belief MetricMapAgent::belief() const {
  Belief belief{navigator_.pose(), std::nullopt, navigator_.map().Picture()};
  if (target_) belief.target = sim::PlanarPose{target_->x, target_->y, 0.0};
  return belief;
}

std::optional<sim::Action> MetricMapAgent::GoToFrontier() {
  const auto plan = navigator_.ToFrontier();
  target_ = navigator_.frontier();
  if (!plan) return std::nullopt;
  return navigator_.Steer(plan->point);
}

sim::Action MetricMapAgent::Explore() {
  if (const auto action = GoOn()) return *action;
  navigator_.ForgetFeltWalls();
  if (const auto action = GoOn()) return *action;
  target_.reset();
  navigator_.ForgetMap();
  approach_.Reconsider();
  return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
}

}  // namespace bulletnav::agent
