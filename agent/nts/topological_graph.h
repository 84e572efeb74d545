// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "agent/belief.h"
#include "agent/mapping/metric_map.h"
#include "agent/models/semantic_model.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// A place that was visited, known by its panorama.
struct RegularNode {
  PanoramaCode code;
  sim::PlanarPose pose;  // of the body when it was made, by odometry
};

/// A place where the panorama of a regular node suggests to go.
struct GhostNode {
  int id = 0;
  int owner = 0;      // the regular node it hangs on
  int direction = 0;  // of the owner's panorama
  double distance = kNodeRadius;
  std::optional<double> score;
  double off = 0.0;  // radians from the direction's middle
};

/// Two regular nodes next to each other.
struct GraphEdge {
  int a = 0;
  int b = 0;
  sim::PlanarPose b_from_a;  // relative pose, by odometry
};

/// Shortest ways over the edges of a graph. Nodes that cannot be reached cost infinity.
struct GraphRoutes {
  std::vector<double> cost;   // metres, by node
  std::vector<int> previous;  // by node; -1: the way begins there

  /// The nodes of the way to `node`, from its beginning.
  std::vector<int> To(int node) const;
};

/// The map of Neural Topological SLAM, section 4: regular nodes with numbers 0, 1, ..., ghost nodes
/// that each hang on one of them, and edges with relative poses. Poses are in the agent's plane.
class TopologicalGraph {
 public:
  void Clear();

  int AddNode(RegularNode node);
  /// Puts all nodes elsewhere; their ghosts go with them, edges are measured anew.
  void MoveNodes(std::span<const sim::PlanarPose> poses);
  /// Joins two nodes, once; the relative pose is that of their estimates now.
  void AddEdge(int a, int b);
  void RemoveEdge(int a, int b);
  bool HasEdge(int a, int b) const;

  /// Once for each direction of an owner. Returns the ghost's number, which is never used again.
  int AddGhost(int owner, int direction, double distance = kNodeRadius);
  /// At a point, in whatever direction that is of the owner.
  int AddGhostAt(int owner, const Point& point);
  void RemoveGhost(int id);
  const GhostNode* FindGhost(int id) const;
  void SetScore(int id, std::optional<double> score);

  const std::vector<RegularNode>& nodes() const { return nodes_; }
  const std::vector<GhostNode>& ghosts() const { return ghosts_; }
  const std::vector<GraphEdge>& edges() const { return edges_; }

  Point NodePoint(int node) const;
  Point GhostPoint(const GhostNode& ghost) const;
  /// Bearing of a point in the panorama of a node.
  double BearingFrom(int node, const Point& point) const;

  /// Dijkstra from several beginnings at once: nodes, and what it takes to get to them.
  GraphRoutes Routes(std::span<const std::pair<int, double>> starts) const;

  /// Regular nodes first, then the ghosts in their order.
  GraphPicture Picture() const;

 private:
  /// Pose of a node seen from another, by their estimates now.
  sim::PlanarPose Seen(int from, int to) const;

  std::vector<RegularNode> nodes_;
  std::vector<GhostNode> ghosts_;
  std::vector<GraphEdge> edges_;
  int next_ghost_ = 0;
};

}  // namespace bulletnav::agent
