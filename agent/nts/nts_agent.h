// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "agent/agent.h"
#include "agent/mapping/goal_approach.h"
#include "agent/mapping/map_navigator.h"
#include "agent/mapping/progress_watch.h"
#include "agent/models/usual_slots.h"
#include "agent/nts/global_policy.h"
#include "agent/nts/graph_update.h"
#include "agent/nts/nts_spec.h"
#include "agent/nts/view_ghosts.h"

namespace bulletnav::agent {

/// Neural Topological SLAM, section 4.1: graph update, global policy, and a local policy that plans
/// on a metric map. Each observation is encoded once.
/// What the paper leaves open: a goal seen from the body itself is gone to at once and remembered
/// until it proves wrong; a reached ghost becomes a node; a ghost, an edge or a sight of the goal
/// that cannot be walked to for PolicySpec::patience steps is given up; where known floor ends near
/// a new node it gets a ghost too; with nothing left on the graph the body walks to frontiers of
/// its metric map until there is a new node.
class NtsAgent : public Agent {
 public:
  using Config = NtsSpec;

  NtsAgent(const Config& config, const AgentContext& context, GhostChoice choice);

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) { return SemanticAndMapSlots(rig); }

  void Reset(const Panorama& goal, std::uint64_t seed) override;
  void NextGoal(const Panorama& goal, std::uint64_t seed) override;
  sim::Action Act(const Observation& observation) override;
  Belief belief() const override;

 private:
  void LookForGoal(const PanoramaCode& code);
  /// Makes a node of the present view if it shows a better way than the graph knows.
  bool TakeView(const PanoramaCode& code, const std::optional<Subgoal>& known);
  void MakeNode(const PanoramaCode& code);
  /// Gives the newest node a ghost for each new opening.
  void AddOpenings();
  /// Where known floor ends nearby and no ghost stands for it: F_G tells only of openings that some
  /// direction meets 3 m away, not of a door beside the body.
  std::vector<Point> NewOpenings();
  Opening SeenFromBody(const Point& point) const;
  /// Takes ghosts off the graph around which the local map has no end of known floor, or where the
  /// body could not get.
  void DropKnownGhosts();
  bool IsSeen(const Point& ghost) const;
  /// Whether there is nothing new there: it has been visited, seen or given up.
  bool IsKnown(const Point& point) const;
  bool IsVisited(const Point& point, double radius) const;
  bool IsGivenUp(const Point& point) const;
  /// Along the graph; absent if it leads nowhere.
  std::optional<sim::Action> Travel(const PanoramaCode& code);
  /// Sets `subgoal_`, and asks the map how far ghosts really are until none is nearer. Absent if
  /// there is none, or the map knows no way there.
  std::optional<Waypoint> Choose();
  std::optional<sim::Action> Walk(const Subgoal& subgoal, std::optional<Waypoint> plan);
  bool IsGhostReached(const Subgoal& subgoal) const;
  void GiveUp(const Subgoal& subgoal);
  sim::Action Wander();

  NtsSpec spec_;
  std::shared_ptr<SemanticModel> model_;
  MapNavigator navigator_;
  GraphUpdate update_;
  GlobalPolicy policy_;
  ProgressWatch watch_;
  sim::Rng rng_{0, "nts agent"};
  GhostChoice choice_;
  PairPrediction view_;  // of the goal, in this step
  GoalApproach approach_;
  struct GivenUp {
    Point point;
    int owner = 0;
  };
  std::vector<GivenUp> given_up_;   // where ghosts were that could not be walked to
  std::optional<Point> target_;     // in this step
  std::optional<Subgoal> subgoal_;  // walked to in this step; absent off the graph
};

}  // namespace bulletnav::agent
