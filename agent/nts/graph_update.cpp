// SPDX-License-Identifier: MIT
#include "agent/nts/graph_update.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "agent/perception/relative_pose.h"

namespace bulletnav::agent {

bool Localisation::Sees(int node) const {
  return std::any_of(visible.begin(), visible.end(), [&](const Sight& sight) {
    return sight.node == node;
  });
}

GraphUpdate::GraphUpdate(const GraphSpec& spec, std::shared_ptr<SemanticModel> model)
    : spec_(spec), model_(std::move(model)), closer_(spec.loops) {}

void GraphUpdate::Reset() {
  graph_.Clear();
  here_ = {};
  misses_ = 0;
  closer_.Reset();
  before_.clear();
}

const Localisation& GraphUpdate::Observe(const PanoramaCode& code, const sim::PlanarPose& pose) {
  here_.is_new = false;
  closer_.Move(pose);
  CloseLoops(code, Look(code, pose));
  const int node = ChooseCurrent();
  misses_ = node >= 0 ? 0 : misses_ + 1;
  if (node >= 0) MoveTo(node);
  if (here_.current < 0 || misses_ >= spec_.misses) MakeNode(code, pose);
  return here_;
}

void GraphUpdate::MakeNode(const PanoramaCode& code, const sim::PlanarPose& pose) {
  const int node = graph_.AddNode({code, pose});
  closer_.AddNode();
  here_.visible.push_back({node, 0.0});
  MoveTo(node);
  here_.is_new = true;
  misses_ = 0;
  RemoveVisited(node);
  AddGhosts(node);
}

std::vector<int> GraphUpdate::NodesNear(const Point& point) const {
  std::vector<int> near;
  for (int i = 0; i < static_cast<int>(graph_.nodes().size()); ++i) {
    const bool is_beside = i == here_.current || graph_.HasEdge(i, here_.current);
    if (is_beside || Distance(graph_.NodePoint(i), point) <= spec_.search_radius) near.push_back(i);
  }
  return near;
}

std::vector<LoopCloser::Sight> GraphUpdate::Look(const PanoramaCode& code,
                                                 const sim::PlanarPose& pose) {
  here_.visible.clear();
  const std::vector<int> near = NodesNear({pose.x, pose.y});
  std::vector<const PanoramaCode*> sources;
  sources.reserve(near.size());
  for (const int i : near) sources.push_back(&graph_.nodes()[static_cast<std::size_t>(i)].code);
  const std::vector<PairPrediction> predictions = model_->Compare(sources, code);
  const bool is_due = closer_.IsDue();
  std::vector<LoopCloser::Sight> known_again;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double distance = predictions[i].distance;
    if (predictions[i].same_node < spec_.same_node || distance > spec_.node_reach) continue;
    here_.visible.push_back({near[i], distance});
    const bool is_certain = predictions[i].same_node >= spec_.loops.certainty;
    if (!is_due || !is_certain || !closer_.IsOld(near[i])) continue;
    known_again.push_back({near[i], predictions[i], {}});
  }
  return known_again;
}

void GraphUpdate::CloseLoops(const PanoramaCode& code, std::vector<LoopCloser::Sight> known_again) {
  const std::array<const PanoramaCode*, 1> here = {&code};
  for (LoopCloser::Sight& sight : known_again) {
    const RegularNode& node = graph_.nodes()[static_cast<std::size_t>(sight.node)];
    sight.of_node = model_->Compare(here, node.code).front();
  }
  before_.clear();
  const auto poses = closer_.Close(known_again);
  if (!poses) return;
  before_.reserve(graph_.nodes().size());
  for (const RegularNode& node : graph_.nodes()) before_.push_back(node.pose);
  graph_.MoveNodes(*poses);
}

Point GraphUpdate::MovedWith(int node, const Point& point) const {
  const auto i = static_cast<std::size_t>(node);
  if (i >= before_.size()) return point;
  const sim::PlanarPose seen =
      sim::Compose(sim::Inverse(before_[i]), sim::PlanarPose{point.x, point.y, 0.0});
  const sim::PlanarPose moved = sim::Compose(graph_.nodes()[i].pose, seen);
  return {moved.x, moved.y};
}

int GraphUpdate::ChooseCurrent() const {
  int best = -1;
  double best_distance = 0.0;
  for (const Localisation::Sight& sight : here_.visible) {
    const double bonus = sight.node == here_.current ? spec_.switch_margin : 0.0;
    if (best >= 0 && sight.distance - bonus >= best_distance) continue;
    best = sight.node;
    best_distance = sight.distance - bonus;
  }
  return best;
}

void GraphUpdate::MoveTo(int node) {
  const int last = here_.current;
  here_.current = node;
  if (last >= 0 && last != node) Join(last, node);
}

void GraphUpdate::Join(int a, int b) {
  if (graph_.HasEdge(a, b)) return;
  graph_.AddEdge(a, b);
  const std::vector<GhostNode> ghosts = graph_.ghosts();
  for (const GhostNode& ghost : ghosts) {
    if (ghost.owner != a && ghost.owner != b) continue;
    const int other = ghost.owner == a ? b : a;
    const double bearing = graph_.BearingFrom(ghost.owner, graph_.NodePoint(other));
    // What lies well beyond the other node stays.
    const bool is_there = ghost.distance <= Distance(graph_.NodePoint(a), graph_.NodePoint(b)) +
                                                spec_.ghost_clearance;
    if (is_there && DirectionOf(bearing) == ghost.direction) graph_.RemoveGhost(ghost.id);
  }
}

void GraphUpdate::AddGhosts(int node) {
  const auto& code = graph_.nodes()[static_cast<std::size_t>(node)].code;
  const std::array<float, kDirections> explorable = model_->Explorable(code);
  for (int i = 0; i < kDirections; ++i) {
    const bool is_open = explorable[static_cast<std::size_t>(i)] >= spec_.explorable;
    if (is_open && !IsTaken(node, i)) graph_.AddGhost(node, i);
  }
}

bool GraphUpdate::IsTaken(int node, int direction) const {
  const Point ghost = graph_.GhostPoint({0, node, direction, kNodeRadius, std::nullopt});
  for (int i = 0; i < static_cast<int>(graph_.nodes().size()); ++i) {
    if (i == node) continue;
    const Point other = graph_.NodePoint(i);
    if (Distance(other, ghost) < spec_.ghost_clearance) return true;
    const bool is_there = DirectionOf(graph_.BearingFrom(node, other)) == direction;
    if (is_there && graph_.HasEdge(i, node)) return true;
  }
  return false;
}

void GraphUpdate::RemoveVisited(int node) {
  const std::vector<GhostNode> ghosts = graph_.ghosts();
  for (const GhostNode& ghost : ghosts) {
    const double distance = Distance(graph_.GhostPoint(ghost), graph_.NodePoint(node));
    if (distance < spec_.ghost_clearance) graph_.RemoveGhost(ghost.id);
  }
}

}  // namespace bulletnav::agent
