// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "agent/agent.h"
#include "agent/mapping/goal_approach.h"
#include "agent/mapping/map_navigator.h"
#include "agent/models/goal_estimator.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// What the configs of all agents on a metric map have.
struct MetricMapAgentSpec {
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
  /// Throws Error.
  void Validate() const;
};

/// Maps, explores until the goal is seen, then walks there and stops; what such agents differ in is
/// how they explore. Source: Neural Topological SLAM, section 5.1. What the paper leaves open:
/// where the goal was last seen is kept on the map until the body gets there; with nothing left to
/// explore, felt walls and then the map are forgotten, for drift has closed it.
/// Its slots are those of SemanticAndMapSlots (usual_slots.h).
class MetricMapAgent : public Agent {
 public:
  /// `name` is that of the agent: its chances are its own.
  MetricMapAgent(std::string_view name, const MetricMapAgentSpec& spec,
                 const AgentContext& context);

  void Reset(const Panorama& goal, std::uint64_t seed) final;
  void NextGoal(const Panorama& goal, std::uint64_t seed) final;
  sim::Action Act(const Observation& observation) final;
  Belief belief() const final;

 protected:
  /// The next action towards what is not known yet, with SetTarget; absent if no way leads on.
  virtual std::optional<sim::Action> GoOn() = 0;
  /// Forgets what was done for the last goal.
  virtual void Forget() {}

  /// To the nearest frontier; absent if there is none that can be got to.
  std::optional<sim::Action> GoToFrontier();
  /// Where the body is now said to go.
  void SetTarget(const std::optional<Point>& target) { target_ = target; }
  MapNavigator& navigator() { return navigator_; }
  sim::Rng& rng() { return rng_; }

 private:
  sim::Action Explore();

  std::string_view name_;
  MapNavigator navigator_;
  std::shared_ptr<GoalEstimator> estimator_;
  Panorama goal_;
  sim::Rng rng_;
  GoalApproach approach_;
  std::optional<Point> target_;
};

}  // namespace bulletnav::agent
