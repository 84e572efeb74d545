// SPDX-License-Identifier: MIT
#include "agent/nts/topological_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "agent/perception/relative_pose.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {

std::vector<int> GraphRoutes::To(int node) const {
  std::vector<int> way;
  for (int i = node; i >= 0; i = previous[static_cast<std::size_t>(i)]) way.push_back(i);
  std::reverse(way.begin(), way.end());
  return way;
}

void TopologicalGraph::Clear() {
  nodes_.clear();
  ghosts_.clear();
  edges_.clear();
  next_ghost_ = 0;
}

int TopologicalGraph::AddNode(RegularNode node) {
  nodes_.push_back(std::move(node));
  return static_cast<int>(nodes_.size()) - 1;
}

void TopologicalGraph::MoveNodes(std::span<const sim::PlanarPose> poses) {
  BULLETNAV_CHECK(poses.size() == nodes_.size());
  for (std::size_t i = 0; i < poses.size(); ++i) nodes_[i].pose = poses[i];
  for (GraphEdge& edge : edges_) edge.b_from_a = Seen(edge.a, edge.b);
}

void TopologicalGraph::AddEdge(int a, int b) {
  BULLETNAV_CHECK(a != b);
  if (HasEdge(a, b)) return;
  edges_.push_back({a, b, Seen(a, b)});
}

sim::PlanarPose TopologicalGraph::Seen(int from, int to) const {
  return sim::Compose(sim::Inverse(nodes_.at(static_cast<std::size_t>(from)).pose),
                      nodes_.at(static_cast<std::size_t>(to)).pose);
}

void TopologicalGraph::RemoveEdge(int a, int b) {
  std::erase_if(edges_, [&](const GraphEdge& edge) {
    return (edge.a == a && edge.b == b) || (edge.a == b && edge.b == a);
  });
}

bool TopologicalGraph::HasEdge(int a, int b) const {
  return std::any_of(edges_.begin(), edges_.end(), [&](const GraphEdge& edge) {
    return (edge.a == a && edge.b == b) || (edge.a == b && edge.b == a);
  });
}

int TopologicalGraph::AddGhost(int owner, int direction, double distance) {
  for (const GhostNode& ghost : ghosts_) {
    if (ghost.owner == owner && ghost.direction == direction) return ghost.id;
  }
  ghosts_.push_back({next_ghost_, owner, direction, distance, std::nullopt});
  return next_ghost_++;
}

int TopologicalGraph::AddGhostAt(int owner, const Point& point) {
  const double bearing = BearingFrom(owner, point);
  const int direction = DirectionOf(bearing);
  const double off = sim::WrapAngle(bearing - BearingOf(direction));
  const double distance = Distance(NodePoint(owner), point);
  ghosts_.push_back({next_ghost_, owner, direction, distance, std::nullopt, off});
  return next_ghost_++;
}

void TopologicalGraph::RemoveGhost(int id) {
  std::erase_if(ghosts_, [&](const GhostNode& ghost) {
    return ghost.id == id;
  });
}

const GhostNode* TopologicalGraph::FindGhost(int id) const {
  for (const GhostNode& ghost : ghosts_) {
    if (ghost.id == id) return &ghost;
  }
  return nullptr;
}

void TopologicalGraph::SetScore(int id, std::optional<double> score) {
  for (GhostNode& ghost : ghosts_) {
    if (ghost.id == id) ghost.score = score;
  }
}

Point TopologicalGraph::NodePoint(int node) const {
  const sim::PlanarPose& pose = nodes_.at(static_cast<std::size_t>(node)).pose;
  return {pose.x, pose.y};
}

Point TopologicalGraph::GhostPoint(const GhostNode& ghost) const {
  const sim::PlanarPose& pose = nodes_.at(static_cast<std::size_t>(ghost.owner)).pose;
  const double heading = pose.yaw + BearingOf(ghost.direction) + ghost.off;
  return {pose.x + ghost.distance * sim::Cos(heading), pose.y + ghost.distance * sim::Sin(heading)};
}

double TopologicalGraph::BearingFrom(int node, const Point& point) const {
  const sim::PlanarPose& pose = nodes_.at(static_cast<std::size_t>(node)).pose;
  return sim::WrapAngle(sim::Atan2(point.y - pose.y, point.x - pose.x) - pose.yaw);
}

GraphRoutes TopologicalGraph::Routes(std::span<const std::pair<int, double>> starts) const {
  std::vector<std::vector<std::pair<int, double>>> beside(nodes_.size());
  for (const GraphEdge& edge : edges_) {
    const double length = std::hypot(edge.b_from_a.x, edge.b_from_a.y);
    beside[static_cast<std::size_t>(edge.a)].emplace_back(edge.b, length);
    beside[static_cast<std::size_t>(edge.b)].emplace_back(edge.a, length);
  }
  GraphRoutes routes;
  routes.cost.assign(nodes_.size(), std::numeric_limits<double>::infinity());
  routes.previous.assign(nodes_.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](int node, double cost, int previous) {
    double& best = routes.cost[static_cast<std::size_t>(node)];
    if (cost >= best) return;
    best = cost;
    routes.previous[static_cast<std::size_t>(node)] = previous;
    queue.emplace(cost, node);
  };
  for (const auto& [node, cost] : starts) offer(node, cost, -1);
  while (!queue.empty()) {
    const auto [cost, node] = queue.top();
    queue.pop();
    if (cost > routes.cost[static_cast<std::size_t>(node)]) continue;
    for (const auto& [next, length] : beside[static_cast<std::size_t>(node)]) {
      offer(next, cost + length, node);
    }
  }
  return routes;
}

GraphPicture TopologicalGraph::Picture() const {
  GraphPicture picture;
  for (const RegularNode& node : nodes_) {
    picture.nodes.push_back({node.pose.x, node.pose.y, false, std::nullopt});
  }
  for (const GraphEdge& edge : edges_) picture.edges.emplace_back(edge.a, edge.b);
  for (const GhostNode& ghost : ghosts_) {
    const Point p = GhostPoint(ghost);
    picture.edges.emplace_back(ghost.owner, static_cast<int>(picture.nodes.size()));
    picture.nodes.push_back({p.x, p.y, true, ghost.score});
  }
  return picture;
}

}  // namespace bulletnav::agent
