// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "agent/mapping/goal_approach.h"
#include "agent/nts/graph_update.h"
#include "agent/nts/nts_spec.h"
#include "agent/nts/topological_graph.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Which ghost node is explored: the best by F_S, or any, which is the paper's ablation.
enum class GhostChoice { kScore, kRandom };

/// Where to go next on the graph.
struct Subgoal {
  std::vector<int> path;     // regular nodes, from one that sees the body to the long-term goal
  std::optional<int> ghost;  // beyond the last of them; absent if the goal is seen from there
  Point point;               // where to walk now
  double way = 0.0;          // metres to the long-term goal over the graph
  double all = 0.0;          // and from there to the goal, as F_S has it; 0 if the goal is seen

  /// Whether `point` is the ghost, or the goal, itself.
  bool is_last() const { return path.size() == 1; }
};

/// Chooses where to go: Global Policy of Neural Topological SLAM, section 4.1. A node in which the
/// goal is localised by F_L, else the ghost node that F_S speaks for most; the next node on the
/// shortest way there is the subgoal. Ours: ways to ghosts count too, in the metres that scores
/// are made of, and a chosen ghost is kept unless another is clearly better.
class GlobalPolicy {
 public:
  GlobalPolicy(const PolicySpec& spec, std::shared_ptr<SemanticModel> model, GhostChoice choice);

  /// `seed`: for random ghosts.
  void NewGoal(PanoramaCode goal, std::uint64_t seed);
  const PanoramaCode& goal() const { return goal_; }

  /// Compares nodes that are new with the goal, and writes scores to ghosts.
  void Read(TopologicalGraph* graph);

  /// Absent if there is nowhere to go. `here`: the body in the agent's plane; `approach` knows
  /// where the goal is not, whichever node says so. Expects: Read before.
  std::optional<Subgoal> Choose(const TopologicalGraph& graph, const Localisation& localisation,
                                const Point& here, const GoalApproach& approach);

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
  std::optional<Subgoal> ToGoal(const Place& place) const;
  std::optional<Subgoal> ToGhost(const Place& place);
  double WayTo(const Place& place, const GhostNode& ghost) const;
  /// What is minimised: metres to a ghost and from there to the goal.
  double AllOf(const Place& place, const GhostNode& ghost) const;
  const GhostNode* BestGhost(const Place& place) const;
  const GhostNode* RandomGhost(const Place& place);
  Subgoal Lead(const Place& place, int node, const Point& last) const;

  PolicySpec spec_;
  std::shared_ptr<SemanticModel> model_;
  GhostChoice choice_;
  PanoramaCode goal_;
  sim::Rng rng_{0, "nts"};
  std::vector<PairPrediction> views_;  // of the goal, by node
  std::set<int> refuted_;
  std::optional<int> chosen_;
};

}  // namespace bulletnav::agent
