// SPDX-License-Identifier: MIT
#include <optional>

#include "agent/mapping/goal_approach.h"
#include "agent/mapping/map_navigator.h"
#include "agent/models/usual_slots.h"
#include "agent/perception/model_goal_estimator.h"
#include "agent/registry.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// Maps with depth, walks to the nearest frontier until the goal is seen, then to the goal.
/// Source: Neural Topological SLAM, section 5.1 "Metric Spatial Map + FBE + Local". What the paper
/// leaves open: where the goal was last seen is kept on the map until the body gets there; with
/// nothing left to explore, felt walls and then the map are forgotten, for drift has closed it.
class MetricMapFbeAgent final : public Agent {
 public:
  static constexpr std::string_view kName = "metric_map_fbe";

  struct Config {
    NavigatorSpec navigator;
    double goal_seen = 0.5;        // probability from which a semantic model sees the goal
    int sightings = 2;             // of the goal that must agree
    double stop_distance = 0.5;    // metres to the goal, by F_R; episodes ask for less than 1
    double stop_certainty = 0.95;  // probability that it is the goal, to stop there

    template <class V>
    void Visit(V& v) {
      v("navigator", navigator);
      v("goal_seen", goal_seen);
      v("sightings", sightings);
      v("stop_distance", stop_distance);
      v("stop_certainty", stop_certainty);
    }
    void Validate() const {
      if (!(goal_seen >= 0.0 && goal_seen <= 1.0)) throw sim::Error("goal_seen must be in [0, 1]");
      if (sightings < 1) throw sim::Error("sightings must be at least 1");
      if (!(stop_certainty > 0.0 && stop_certainty < 1.0)) {
        throw sim::Error("stop_certainty must lie between 0 and 1");
      }
      if (!(stop_distance > 0.0)) throw sim::Error("stop_distance must be positive");
    }
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) { return SemanticAndMapSlots(rig); }

  MetricMapFbeAgent(const Config& config, const AgentContext& context)
      : config_(config),
        navigator_(context.rig, config.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
        estimator_(EstimatorOf(config, context.models)),
        approach_(ApproachOf(config)) {}

  void Reset(const Panorama& goal, std::uint64_t seed) override {
    navigator_.Reset();
    NextGoal(goal, seed);
  }

  void NextGoal(const Panorama& goal, std::uint64_t seed) override {
    goal_ = goal;
    rng_ = sim::Rng(seed, kName);
    approach_.Reset();
    target_.reset();
  }

  sim::Action Act(const Observation& observation) override {
    navigator_.Observe(observation);
    approach_.See(estimator_->Estimate(observation.panorama, goal_), navigator_);
    target_ = approach_.target();
    std::optional<sim::Action> action = approach_.Act(&navigator_);
    if (!action) action = Explore();
    navigator_.Took(*action);
    return *action;
  }

  Belief belief() const override {
    Belief belief{navigator_.pose(), std::nullopt, navigator_.map().Picture()};
    if (target_) belief.target = sim::PlanarPose{target_->x, target_->y, 0.0};
    return belief;
  }

 private:
  /// A model that estimates goals by itself, as oracles do, is taken at its word.
  static std::shared_ptr<GoalEstimator> EstimatorOf(const Config& config, const Models& models) {
    if (auto estimator = models.Find<GoalEstimator>(kSemanticModel)) return estimator;
    return std::make_shared<ModelGoalEstimator>(models.Need<SemanticModel>(kSemanticModel),
                                                config.goal_seen);
  }

  sim::Action Explore() {
    if (const auto action = GoToFrontier()) return *action;
    navigator_.ForgetFeltWalls();
    if (const auto action = GoToFrontier()) return *action;
    target_.reset();
    navigator_.ForgetMap();
    approach_.Reconsider();
    return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
  }

  std::optional<sim::Action> GoToFrontier() {
    const auto plan = navigator_.ToFrontier();
    target_ = navigator_.frontier();
    if (!plan) return std::nullopt;
    return navigator_.Steer(plan->point);
  }

  Config config_;
  MapNavigator navigator_;
  std::shared_ptr<GoalEstimator> estimator_;
  Panorama goal_;
  sim::Rng rng_{0, kName};
  GoalApproach approach_;
  std::optional<Point> target_;
};

const AgentRegistration<MetricMapFbeAgent> registration;

}  // namespace
}  // namespace bulletnav::agent
