// SPDX-License-Identifier: MIT
#include "agent/nts/global_policy.h"

#include <algorithm>
#include <cmath>

#include "agent/perception/relative_pose.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

// Metres from a node to a place of which it says something: nearer, its direction means little,
// farther off other places lie in it as well.
constexpr double kNeighbourFrom = 1.0;
constexpr double kNeighbourTo = 4.5;

std::vector<int> NeighboursOf(const TopologicalGraph& graph, int node) {
  std::vector<int> neighbours;
  for (const GraphEdge& edge : graph.edges()) {
    if (edge.a == node) neighbours.push_back(edge.b);
    if (edge.b == node) neighbours.push_back(edge.a);
  }
  return neighbours;
}

}  // namespace

GlobalPolicy::GlobalPolicy(const PolicySpec& spec, std::shared_ptr<SemanticModel> model,
                           GhostChoice choice)
    : spec_(spec), model_(std::move(model)), choice_(choice) {}

void GlobalPolicy::NewGoal(PanoramaCode goal, std::uint64_t seed) {
  goal_ = std::move(goal);
  rng_ = sim::Rng(seed, "nts");
  views_.clear();
  refuted_.clear();
  chosen_.reset();
  seen_at_.clear();
  known_ways_.Clear();
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
    const double own = view.score[static_cast<std::size_t>(ghost.direction)];
    const std::vector<int> neighbours = NeighboursOf(*graph, ghost.owner);
    graph->SetScore(ghost.id, MeanScore(*graph, graph->GhostPoint(ghost), own, neighbours));
  }
}

double GlobalPolicy::MeanScore(const TopologicalGraph& graph, const Point& point, double own,
                               std::span<const int> neighbours) const {
  double sum = own;
  double weights = 1.0;
  for (const int node : neighbours) {
    const double distance = Distance(graph.NodePoint(node), point);
    if (distance < kNeighbourFrom || distance > kNeighbourTo) continue;
    const auto direction = static_cast<std::size_t>(DirectionOf(graph.BearingFrom(node, point)));
    sum += spec_.neighbour_weight * views_[static_cast<std::size_t>(node)].score[direction];
    weights += spec_.neighbour_weight;
  }
  return sum / weights;
}

double GlobalPolicy::AllOfView(const TopologicalGraph& graph, const Localisation& localisation,
                               const Point& here, const ViewGhost& ghost,
                               const Point& point) const {
  std::vector<int> neighbours;  // if the view were a node
  for (const Localisation::Sight& sight : localisation.visible) neighbours.push_back(sight.node);
  const double way = std::max(ghost.distance, known_ways_.Least(here, point));
  return WayByGhost(spec_, way, MeanScore(graph, point, ghost.score, neighbours));
}

void GlobalPolicy::Remember(const Localisation& localisation, const Point& here) {
  for (const Localisation::Sight& sight : localisation.visible) seen_at_[sight.node] = here;
  std::erase_if(seen_at_, [&](const auto& seen) {
    return !localisation.Sees(seen.first) && Distance(seen.second, here) >= spec_.sight_memory;
  });
  if (seen_at_.empty() && localisation.current >= 0) seen_at_[localisation.current] = here;
}

std::optional<Subgoal> GlobalPolicy::Choose(const TopologicalGraph& graph,
                                            const Localisation& localisation, const Point& here,
                                            const GoalApproach& approach) {
  Remember(localisation, here);
  std::vector<std::pair<int, double>> starts;
  for (const auto& [node, at] : seen_at_) {
    starts.emplace_back(node, Distance(graph.NodePoint(node), here));
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
  return {pose.x + goal.distance * sim::Cos(heading), pose.y + goal.distance * sim::Sin(heading)};
}

void GlobalPolicy::Follow(const Subgoal& subgoal) {
  if (subgoal.ghost) chosen_ = subgoal.ghost;
}

std::optional<Subgoal> GlobalPolicy::ToGoal(const Place& place) {
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
  if (ghost == nullptr) return std::nullopt;
  Subgoal subgoal = Lead(place, ghost->owner, place.graph.GhostPoint(*ghost));
  subgoal.ghost = ghost->id;
  subgoal.way = WayTo(place, *ghost);
  subgoal.all = AllOf(place, *ghost);
  return subgoal;
}

double GlobalPolicy::WayTo(const Place& place, const GhostNode& ghost) const {
  const double least = known_ways_.Least(place.here, place.graph.GhostPoint(ghost));
  return std::max(WayOverGraph(place, ghost), least);
}

double GlobalPolicy::WayOverGraph(const Place& place, const GhostNode& ghost) const {
  // What hangs on a node that sees the body need not be gone to by way of that node.
  if (ghost.owner == place.localisation.current || seen_at_.contains(ghost.owner)) {
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

Subgoal GlobalPolicy::Lead(const Place& place, int node, const Point& last) {
  Subgoal subgoal;
  subgoal.path = place.routes.To(node);
  subgoal.point = last;
  // A node that is reached although it does not know the body.
  while (subgoal.path.size() > 1) {
    subgoal.point = place.graph.NodePoint(subgoal.path[1]);
    if (Distance(subgoal.point, place.here) > spec_.node_reached) break;
    seen_at_[subgoal.path[1]] = place.here;
    subgoal.path.erase(subgoal.path.begin());
    subgoal.point = last;
  }
  return subgoal;
}

}  // namespace bulletnav::agent
