// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "agent/mapping/goal_approach.h"
#include "agent/mapping/progress_watch.h"
#include "agent/nts/nts_agent.h"
#include "agent/perception/relative_pose.h"
#include "agent/registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Neural Topological SLAM without its graph: goes where the present panorama has the highest
/// score, and looks anew when it has got there: the ablation "NTS w/o Graph" of section 6.1. Its
/// local policy keeps its metric map, and a goal that it sees is gone to as by the others.
class NtsWithoutGraph final : public Agent {
 public:
  static constexpr std::string_view kName = "nts_without_graph";

  struct Config {
    NavigatorSpec navigator;
    double explorable = 0.5;       // probability from which a direction may be taken
    double goal_seen = 0.5;        // probability from which the goal is gone to
    int sightings = 2;             // of the goal that must agree
    double stop_distance = 0.5;    // metres, by F_R
    double stop_certainty = 0.95;  // probability that it is the goal, to stop there
    double walk = 2.5;             // metres until it looks anew
    int patience = 20;             // steps without coming nearer until it looks anew

    template <class V>
    void Visit(V& v) {
      v("navigator", navigator);
      v("explorable", explorable);
      v("goal_seen", goal_seen);
      v("sightings", sightings);
      v("stop_distance", stop_distance);
      v("stop_certainty", stop_certainty);
      v("walk", walk);
      v("patience", patience);
    }
    void Validate() const {
      if (!(stop_distance > 0.0 && walk > 0.0)) {
        throw sim::Error("stop_distance and walk must be positive");
      }
      for (const double probability : {explorable, goal_seen, stop_certainty}) {
        if (probability > 0.0 && probability < 1.0) continue;
        throw sim::Error("explorable, goal_seen and stop_certainty must lie between 0 and 1");
      }
      if (sightings < 1) throw sim::Error("sightings must be at least 1");
      if (patience < 1) throw sim::Error("patience must be at least 1");
    }
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) { return SemanticAndMapSlots(rig); }

  NtsWithoutGraph(const Config& config, const AgentContext& context)
      : config_(config),
        model_(context.models.Need<SemanticModel>(kSemanticModel)),
        navigator_(context.rig, config.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
        watch_(config.patience, kLeastProgress),
        approach_(ApproachOf(config)) {}

  void Reset(const Panorama& goal, std::uint64_t seed) override {
    navigator_.Reset();
    NextGoal(goal, seed);
  }

  void NextGoal(const Panorama& goal, std::uint64_t seed) override {
    goal_ = model_->Encode({&goal, 1}).front();
    rng_ = sim::Rng(seed, kName);
    watch_.Reset();
    approach_.Reset();
    target_.reset();
    shown_.reset();
  }

  sim::Action Act(const Observation& observation) override {
    navigator_.Observe(observation);
    const sim::Action action = Decide(model_->Encode({&observation.panorama, 1}).front());
    navigator_.Took(action);
    return action;
  }

  Belief belief() const override {
    Belief belief{navigator_.pose(), std::nullopt, navigator_.map().Picture()};
    if (shown_) belief.target = sim::PlanarPose{shown_->x, shown_->y, 0.0};
    return belief;
  }

 private:
  static constexpr double kLeastProgress = 0.25;  // metres

  sim::Action Decide(const PanoramaCode& here) {
    const std::array<const PanoramaCode*, 1> source = {&here};
    const PairPrediction view = model_->Compare(source, goal_).front();
    const bool sees_goal = view.same_node >= config_.goal_seen;
    approach_.See(sees_goal ? std::optional(RelativePoseOf(view)) : std::nullopt, navigator_);
    shown_ = approach_.target();
    if (const auto action = approach_.Act(&navigator_)) {
      target_.reset();  // from there it looks anew
      return *action;
    }
    if (!target_ || IsThere()) ChooseDirection(here, view);
    shown_ = target_;
    return Walk();
  }

  bool IsThere() const {
    return Distance(*target_, navigator_.here()) <= kNodeRadius - config_.walk;
  }

  void ChooseDirection(const PanoramaCode& here, const PairPrediction& view) {
    const std::array<float, kDirections> open = model_->Explorable(here);
    int best = -1;
    for (int i = 0; i < kDirections; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (open[k] < config_.explorable) continue;
      if (best < 0 || view.score[k] > view.score[static_cast<std::size_t>(best)]) best = i;
    }
    if (best < 0) best = rng_.Below(kDirections);
    target_ = navigator_.PointAt(kNodeRadius, BearingOf(best));
    ++target_number_;
  }

  sim::Action Walk() {
    const auto plan = navigator_.Plan(*target_, true);
    if (plan && !watch_.IsStuck(target_number_, plan->distance)) {
      return navigator_.Steer(plan->point);
    }
    navigator_.ForgetFeltWalls();
    target_.reset();
    return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
  }

  Config config_;
  std::shared_ptr<SemanticModel> model_;
  MapNavigator navigator_;
  ProgressWatch watch_;
  PanoramaCode goal_;
  sim::Rng rng_{0, kName};
  GoalApproach approach_;
  std::optional<Point> target_;  // at the end of the chosen direction
  std::optional<Point> shown_;   // what is walked to in this step
  int target_number_ = 0;
};

const AgentRegistration<NtsWithoutGraph> registration;

}  // namespace
}  // namespace bulletnav::agent
