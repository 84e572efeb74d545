// SPDX-License-Identifier: MIT
#include "agent/nts/global_policy.h"

#include <algorithm>
#include <cmath>

#include "agent/nts/view_ghosts.h"
#include "agent/perception/relative_pose.h"

namespace bulletnav::agent {

GlobalPolicy::GlobalPolicy(const PolicySpec& spec, std::shared_ptr<SemanticModel> model,
                           GhostChoice choice)
    : spec_(spec), model_(std::move(model)), choice_(choice) {}

void GlobalPolicy::NewGoal(PanoramaCode goal, std::uint64_t seed) {
  goal_ = std::move(goal);
  rng_ = sim::Rng(seed, "nts");
  views_.clear();
  refuted_.clear();
  chosen_.reset();
}

void GlobalPolicy::Read(TopologicalGraph* graph) {
  if (views_.size() < graph->nodes().size()) {
    std::vector<const PanoramaCode*> sources;
    for (std::size_t i = views_.size(); i < graph->nodes().size(); ++i) {
      sources.push_back(&graph->nodes()[i].code);
    }
    for (const PairPrediction& view : model_->Compare(sources, goal_)) views_.push_back(view);
  }
  const std::vector<GhostNode> ghosts = graph->ghosts();
  for (const GhostNode& ghost : ghosts) {
    const PairPrediction& view = views_[static_cast<std::size_t>(ghost.owner)];
    graph->SetScore(ghost.id, view.score[static_cast<std::size_t>(ghost.direction)]);
  }
}

std::optional<Subgoal> GlobalPolicy::Choose(const TopologicalGraph& graph,
                                            const Localisation& localisation, const Point& here,
                                            const GoalApproach& approach) {
  std::vector<std::pair<int, double>> starts;
  for (const Localisation::Sight& sight : localisation.visible) {
    starts.emplace_back(sight.node, Distance(graph.NodePoint(sight.node), here));
  }
  if (starts.empty() && localisation.current >= 0) {
    const int current = localisation.current;
    starts.emplace_back(current, Distance(graph.NodePoint(current), here));
  }
  const Place place{graph, localisation, here, graph.Routes(starts), approach};
  if (auto subgoal = ToGoal(place)) return subgoal;
  return ToGhost(place);
}

bool GlobalPolicy::HasGoal(const Place& place, int node) const {
  const PairPrediction& view = views_[static_cast<std::size_t>(node)];
  return view.same_node >= spec_.goal_seen && !refuted_.contains(node) &&
         place.approach.MayBeAt(GoalPoint(place.graph, node), view.distance, view.same_node);
}

Point GlobalPolicy::GoalPoint(const TopologicalGraph& graph, int node) const {
  const RelativeGoal goal = RelativePoseOf(views_[static_cast<std::size_t>(node)]);
  const sim::PlanarPose& pose = graph.nodes()[static_cast<std::size_t>(node)].pose;
  const double heading = pose.yaw + goal.bearing;
  return {pose.x + goal.distance * std::cos(heading), pose.y + goal.distance * std::sin(heading)};
}

std::optional<Subgoal> GlobalPolicy::ToGoal(const Place& place) const {
  std::optional<int> best;
  double best_all = 0.0;
  double best_way = 0.0;
  for (int i = 0; i < static_cast<int>(views_.size()); ++i) {
    const double cost = place.routes.cost[static_cast<std::size_t>(i)];
    if (!std::isfinite(cost) || !HasGoal(place, i)) continue;
    const PairPrediction& view = views_[static_cast<std::size_t>(i)];
    const double all = cost + view.distance + spec_.doubt_weight * (1.0 - view.same_node);
    if (best && all >= best_all) continue;
    best = i;
    best_all = all;
    best_way = cost + view.distance;
  }
  if (!best) return std::nullopt;
  Subgoal subgoal = Lead(place, *best, GoalPoint(place.graph, *best));
  subgoal.way = best_way;
  return subgoal;
}

std::optional<Subgoal> GlobalPolicy::ToGhost(const Place& place) {
  const GhostNode* ghost = choice_ == GhostChoice::kScore ? BestGhost(place) : RandomGhost(place);
  if (ghost == nullptr) {
    chosen_.reset();
    return std::nullopt;
  }
  chosen_ = ghost->id;
  Subgoal subgoal = Lead(place, ghost->owner, place.graph.GhostPoint(*ghost));
  subgoal.ghost = ghost->id;
  subgoal.way = WayTo(place, *ghost);
  subgoal.all = AllOf(place, *ghost);
  return subgoal;
}

/// Metres from the body to a ghost; infinite if it cannot be reached.
double GlobalPolicy::WayTo(const Place& place, const GhostNode& ghost) const {
  // What hangs on a node that sees the body need not be gone to by way of that node.
  const bool is_current = ghost.owner == place.localisation.current;
  if (is_current || place.localisation.Sees(ghost.owner)) {
    return Distance(place.here, place.graph.GhostPoint(ghost));
  }
  return place.routes.cost[static_cast<std::size_t>(ghost.owner)] + ghost.distance;
}

double GlobalPolicy::AllOf(const Place& place, const GhostNode& ghost) const {
  return WayByGhost(spec_, WayTo(place, ghost), ghost.score.value_or(0.0));
}

const GhostNode* GlobalPolicy::BestGhost(const Place& place) const {
  const GhostNode* best = nullptr;
  double best_way = 0.0;
  for (const GhostNode& ghost : place.graph.ghosts()) {
    const double bonus = chosen_ == ghost.id ? spec_.change_margin : 0.0;
    const double all = AllOf(place, ghost) - bonus;
    if (!std::isfinite(all)) continue;
    if (best != nullptr && all >= best_way) continue;
    best = &ghost;
    best_way = all;
  }
  return best;
}

const GhostNode* GlobalPolicy::RandomGhost(const Place& place) {
  std::vector<const GhostNode*> reachable;
  for (const GhostNode& ghost : place.graph.ghosts()) {
    if (!std::isfinite(WayTo(place, ghost))) continue;
    if (chosen_ == ghost.id) return &ghost;
    reachable.push_back(&ghost);
  }
  return reachable.empty() ? nullptr : rng_.Pick(reachable);
}

Subgoal GlobalPolicy::Lead(const Place& place, int node, const Point& last) const {
  Subgoal subgoal;
  subgoal.path = place.routes.To(node);
  subgoal.point = last;
  // A node that is reached although it does not know the body is behind.
  while (subgoal.path.size() > 1) {
    subgoal.point = place.graph.NodePoint(subgoal.path[1]);
    if (Distance(subgoal.point, place.here) > spec_.node_reached) break;
    subgoal.path.erase(subgoal.path.begin());
    subgoal.point = last;
  }
  return subgoal;
}

}  // namespace bulletnav::agent
