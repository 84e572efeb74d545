// SPDX-License-Identifier: MIT
#include <optional>
#include <vector>

#include "agent/mapping/goal_approach.h"
#include "agent/mapping/map_navigator.h"
#include "agent/models/usual_slots.h"
#include "agent/perception/model_goal_estimator.h"
#include "agent/policy/exploration_policy.h"
#include "agent/policy/exploration_view.h"
#include "agent/registry.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr const char* kExploration = "exploration";  // the slot's name
constexpr double kArrived = 0.5;                     // metres from a long-term goal
constexpr int kTries = 4;                            // goals asked for in one step

/// Maps with depth, explores by the long-term goals of a learned policy until the goal is seen,
/// then walks there, as metric_map_fbe does. Source: Neural Topological SLAM, section 5.1 "Active
/// Neural SLAM"; Chaplot et al., "Learning to explore using Active Neural SLAM", 2020. Ours: a
/// long-term goal that has been reached, or that no way leads to, is followed by another at once.
class ActiveNeuralSlamAgent final : public Agent {
 public:
  static constexpr std::string_view kName = "active_neural_slam";

  struct Config {
    NavigatorSpec navigator;
    double goal_seen = 0.5;        // probability from which a semantic model sees the goal
    int sightings = 2;             // of the goal that must agree
    double stop_distance = 0.5;    // metres to the goal, by F_R; episodes ask for less than 1
    double stop_certainty = 0.95;  // probability that it is the goal, to stop there
    int goal_steps = 25;           // steps between long-term goals
    bool sample = true;            // goals are drawn as in training; else the likeliest are taken
    bool random_goal = false;      // goals anywhere in the window instead of the policy's

    template <class V>
    void Visit(V& v) {
      v("navigator", navigator);
      v("goal_seen", goal_seen);
      v("sightings", sightings);
      v("stop_distance", stop_distance);
      v("stop_certainty", stop_certainty);
      v("goal_steps", goal_steps);
      v("sample", sample);
      v("random_goal", random_goal);
    }
    void Validate() const {
      if (!(goal_seen >= 0.0 && goal_seen <= 1.0)) throw sim::Error("goal_seen must be in [0, 1]");
      if (sightings < 1) throw sim::Error("sightings must be at least 1");
      if (!(stop_certainty > 0.0 && stop_certainty < 1.0)) {
        throw sim::Error("stop_certainty must lie between 0 and 1");
      }
      if (!(stop_distance > 0.0)) throw sim::Error("stop_distance must be positive");
      if (goal_steps < 1) throw sim::Error("goal_steps must be at least 1");
      RequireExplorationMap(navigator.map);
    }
  };

  /// For random goals: models: {exploration: none}.
  static std::vector<ModelSlot> ModelSlots(const Rig& rig) {
    std::vector<ModelSlot> slots = SemanticAndMapSlots(rig);
    slots.push_back(NeededSlot<ExplorationPolicy>(kExploration, std::string(kName)));
    return slots;
  }

  ActiveNeuralSlamAgent(const Config& config, const AgentContext& context)
      : config_(config),
        navigator_(context.rig, config.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
        estimator_(EstimatorOf(config, context.models)),
        policy_(config.random_goal ? nullptr
                                   : context.models.Need<ExplorationPolicy>(kExploration)),
        approach_(ApproachOf(config)),
        view_(kExplorationBytes) {}

  void Reset(const Panorama& goal, std::uint64_t seed) override {
    navigator_.Reset();
    NextGoal(goal, seed);
  }

  void NextGoal(const Panorama& goal, std::uint64_t seed) override {
    goal_ = goal;
    rng_ = sim::Rng(seed, kName);
    approach_.Reset();
    target_.reset();
    long_term_.reset();
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
    if (const auto action = GoToLongTermGoal()) return *action;
    navigator_.ForgetFeltWalls();
    if (const auto action = GoToLongTermGoal()) return *action;
    target_.reset();
    navigator_.ForgetMap();
    approach_.Reconsider();
    return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
  }

  std::optional<sim::Action> GoToLongTermGoal() {
    const bool is_there = long_term_ && Distance(*long_term_, navigator_.here()) < kArrived;
    if (is_there || steps_left_ <= 0) long_term_.reset();
    for (int i = 0; i < kTries; ++i) {
      if (!long_term_) ChooseLongTermGoal();
      target_ = long_term_;
      if (const auto plan = navigator_.Plan(*long_term_, true)) {
        --steps_left_;
        return navigator_.Steer(plan->point);
      }
      long_term_.reset();
    }
    // The policy knows of no place that can be got to.
    const auto plan = navigator_.ToFrontier();
    target_ = navigator_.frontier();
    if (!plan) return std::nullopt;
    return navigator_.Steer(plan->point);
  }

  void ChooseLongTermGoal() {
    steps_left_ = config_.goal_steps;
    long_term_ = GoalAt(navigator_.map(), navigator_.pose(), SharesOf(AskForGoal()));
  }

  GoalSteps AskForGoal() {
    if (!policy_) return DrawAnyGoal(&rng_);
    WriteExplorationView(navigator_.map(), navigator_.pose(), view_);
    GoalDistribution goal = policy_->Ask(view_, HeadingBin(navigator_.pose().yaw));
    if (!config_.sample) goal.deviation = {};
    return DrawGoal(goal, &rng_);
  }

  Config config_;
  MapNavigator navigator_;
  std::shared_ptr<GoalEstimator> estimator_;
  std::shared_ptr<ExplorationPolicy> policy_;  // null: goals at random
  Panorama goal_;
  sim::Rng rng_{0, kName};
  GoalApproach approach_;
  std::optional<Point> target_;
  std::optional<Point> long_term_;
  int steps_left_ = 0;  // until the next long-term goal
  std::vector<std::uint8_t> view_;
};

const AgentRegistration<ActiveNeuralSlamAgent> registration;

}  // namespace
}  // namespace bulletnav::agent
