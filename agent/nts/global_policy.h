// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "agent/mapping/goal_approach.h"
#include "agent/nts/graph_update.h"
#include "agent/nts/known_ways.h"
#include "agent/nts/nts_spec.h"
#include "agent/nts/topological_graph.h"
#include "agent/nts/view_ghosts.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Which ghost node is explored: the best by F_S, or any, which is the paper's ablation.
enum class GhostChoice { kScore, kRandom };

/// Where to go next on the graph.
struct Subgoal {
  std::vector<int> path;     // regular nodes, from one that sees the body to the long-term goal
  std::optional<int> ghost;  // beyond the last of them; absent if the goal is seen from there
  Point point;               // where to walk now
  double way = 0.0;          // metres to the long-term goal over the graph, or more by the map
  double all = 0.0;          // and from there to the goal, as F_S has it; 0 if the goal is seen

  /// Whether `point` is the ghost, or the goal, itself.
  bool is_last() const { return path.size() == 1; }
};

/// Chooses where to go: Global Policy of Neural Topological SLAM, section 4.1. A node in which the
/// goal is localised by F_L, else the ghost node that F_S speaks for most; the next node on the
/// shortest way there is the subgoal. Ours: ways to ghosts count too, in the metres that scores
/// are made of, by the metric map if it knows of walls; what other nodes nearby say of a ghost
/// counts as well; a ghost that is walked to is kept unless another is clearly better; and a node
/// that saw the body a moment ago still does, so that one that F_L knows in one step and not in the
/// next does not turn it round.
class GlobalPolicy {
 public:
  GlobalPolicy(const PolicySpec& spec, std::shared_ptr<SemanticModel> model, GhostChoice choice);

  /// `seed`: for random ghosts.
  void NewGoal(PanoramaCode goal, std::uint64_t seed);
  const PanoramaCode& goal() const { return goal_; }

  /// Compares nodes that are new with the goal, and writes scores to ghosts.
  void Read(TopologicalGraph* graph);

  /// Absent if there is nowhere to go. `here`: the body in the agent's plane; `approach` knows
  /// where the goal is not, no matter which node says so. Expects: Read before.
  std::optional<Subgoal> Choose(const TopologicalGraph& graph, const Localisation& localisation,
                                const Point& here, const GoalApproach& approach);

  /// It is walked to.
  void Follow(const Subgoal& subgoal);

  /// WayByGhost for a ghost that the present view would have if it were a node. Expects: Choose
  /// before.
  double AllOfView(const TopologicalGraph& graph, const Localisation& localisation,
                   const Point& here, const ViewGhost& ghost, const Point& point) const;

  /// What the map says of ways to ghosts, for the next Choose.
  KnownWays& known_ways() { return known_ways_; }

  /// The goal is not where this node said.
  void Refute(int node) { refuted_.insert(node); }
  /// For when there is nothing left to explore: what was refuted may have been right.
  void Reconsider() { refuted_.clear(); }

 private:
  struct Place {
    const TopologicalGraph& graph;
    const Localisation& localisation;
    Point here;
    GraphRoutes routes;
    const GoalApproach& approach;
  };

  bool HasGoal(const Place& place, int node) const;
  Point GoalPoint(const TopologicalGraph& graph, int node) const;
  std::optional<Subgoal> ToGoal(const Place& place);
  std::optional<Subgoal> ToGhost(const Place& place);
  /// A node that saw the body counts as if it did now, until the body has moved on.
  void Remember(const Localisation& localisation, const Point& here);
  /// What `neighbours` say of a point beside `own`, which counts 1.
  double MeanScore(const TopologicalGraph& graph, const Point& point, double own,
                   std::span<const int> neighbours) const;
  /// Metres from the body to a ghost, as far as is known; infinite if it cannot be reached.
  double WayTo(const Place& place, const GhostNode& ghost) const;
  double WayOverGraph(const Place& place, const GhostNode& ghost) const;
  /// What is minimised: metres to a ghost and from there to the goal.
  double AllOf(const Place& place, const GhostNode& ghost) const;
  const GhostNode* BestGhost(const Place& place) const;
  const GhostNode* RandomGhost(const Place& place);
  Subgoal Lead(const Place& place, int node, const Point& last);

  PolicySpec spec_;
  std::shared_ptr<SemanticModel> model_;
  GhostChoice choice_;
  PanoramaCode goal_;
  sim::Rng rng_{0, "nts"};
  std::vector<PairPrediction> views_;  // of the goal, by node
  std::set<int> refuted_;
  std::optional<int> chosen_;
  std::map<int, Point> seen_at_;  // by node that sees the body: where the body was then
  KnownWays known_ways_;
};

}  // namespace bulletnav::agent
