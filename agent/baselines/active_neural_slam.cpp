// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/metric_map/metric_map_agent.h"
#include "agent/models/usual_slots.h"
#include "agent/policy/exploration_policy.h"
#include "agent/policy/exploration_view.h"
#include "agent/registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr const char* kExploration = "exploration";  // the slot's name
constexpr double kArrived = 0.5;                     // metres from a long-term goal
constexpr int kTries = 4;                            // goals asked for in one step

/// Maps with depth, explores by the long-term goals of a learned policy until the goal is seen,
/// then walks there, as metric_map_fbe does. Source: Neural Topological SLAM, section 5.1 "Active
/// Neural SLAM"; Chaplot et al., "Learning to explore using Active Neural SLAM", 2020. Ours: a
/// long-term goal that has been reached, or that no way leads to, is followed by another at once.
class ActiveNeuralSlamAgent final : public MetricMapAgent {
 public:
  static constexpr std::string_view kName = "active_neural_slam";

  struct Config : MetricMapAgentSpec {
    int goal_steps = 25;       // steps between long-term goals
    bool sample = true;        // goals are drawn as in training; else the likeliest are taken
    bool random_goal = false;  // goals anywhere in the window instead of the policy's

    template <class V>
    void Visit(V& v) {
      MetricMapAgentSpec::Visit(v);
      v("goal_steps", goal_steps);
      v("sample", sample);
      v("random_goal", random_goal);
    }
    void Validate() const {
      MetricMapAgentSpec::Validate();
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
      : MetricMapAgent(kName, config, context),
        goal_steps_(config.goal_steps),
        sample_(config.sample),
        policy_(config.random_goal ? nullptr
                                   : context.models.Need<ExplorationPolicy>(kExploration)),
        view_(kExplorationBytes) {}

 private:
  std::optional<sim::Action> GoOn() override {
    const bool is_there = long_term_ && Distance(*long_term_, navigator().here()) < kArrived;
    if (is_there || steps_left_ <= 0) long_term_.reset();
    for (int i = 0; i < kTries; ++i) {
      if (!long_term_) ChooseLongTermGoal();
      SetTarget(long_term_);
      if (const auto plan = navigator().Plan(*long_term_, true)) {
        --steps_left_;
        return navigator().Steer(plan->point);
      }
      long_term_.reset();
    }
    return GoToFrontier();  // the policy knows of no place that can be got to
  }
  void Forget() override { long_term_.reset(); }

  void ChooseLongTermGoal() {
    steps_left_ = goal_steps_;
    long_term_ = GoalAt(navigator().map(), navigator().pose(), SharesOf(AskForGoal()));
  }

  GoalSteps AskForGoal() {
    if (!policy_) return DrawAnyGoal(&rng());
    WriteExplorationView(navigator().map(), navigator().pose(), view_);
    GoalDistribution goal = policy_->Ask(view_, HeadingBin(navigator().pose().yaw));
    if (!sample_) goal.deviation = {};
    return DrawGoal(goal, &rng());
  }

  int goal_steps_;
  bool sample_;
  std::shared_ptr<ExplorationPolicy> policy_;  // null: goals at random
  std::optional<Point> long_term_;
  int steps_left_ = 0;  // until the next long-term goal
  std::vector<std::uint8_t> view_;
};

const AgentRegistration<ActiveNeuralSlamAgent> registration;

}  // namespace
}  // namespace bulletnav::agent
