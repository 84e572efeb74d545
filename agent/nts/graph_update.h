// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "agent/nts/loop_closer.h"
#include "agent/nts/nts_spec.h"
#include "agent/nts/topological_graph.h"

namespace bulletnav::agent {

/// Where the body is on the graph.
struct Localisation {
  struct Sight {
    int node = 0;
    double distance = 0.0;  // metres, by F_R
  };
  int current = -1;            // the node the body is in; -1 before the first observation
  std::vector<Sight> visible;  // all nodes from which the body can be seen
  bool is_new = false;         // the current node was made in this step

  bool Sees(int node) const;
};

/// Builds the graph from observations: Graph Update of Neural Topological SLAM, section 4.1.
/// An observation is localised with F_L in the node that is nearest by F_R; the present node is
/// kept unless another is clearly nearer. Where no node knows it for some steps, it becomes a node,
/// with a ghost node for each direction of F_G that no regular node takes. With GraphSpec::loops
/// nodes that were drifted away from are put where they belong when they are known again.
class GraphUpdate {
 public:
  GraphUpdate(const GraphSpec& spec, std::shared_ptr<SemanticModel> model);

  void Reset();

  /// Takes in the observation of one step. `pose`: of the body, by odometry.
  const Localisation& Observe(const PanoramaCode& code, const sim::PlanarPose& pose);

  /// Makes a node of the last observation although some node knows it: a ghost was reached.
  void MakeNode(const PanoramaCode& code, const sim::PlanarPose& pose);

  TopologicalGraph& graph() { return graph_; }
  const TopologicalGraph& graph() const { return graph_; }
  const Localisation& localisation() const { return here_; }
  /// Where a point went that hangs on a node, in this step.
  Point MovedWith(int node, const Point& point) const;

 private:
  std::vector<int> NodesNear(const Point& point) const;
  /// Returns the nodes that know the body again after a long way, as far as they tell.
  std::vector<LoopCloser::Sight> Look(const PanoramaCode& code, const sim::PlanarPose& pose);
  /// Asks the other way round, too.
  void CloseLoops(const PanoramaCode& code, std::vector<LoopCloser::Sight> known_again);
  /// The visible node that takes over; -1 if none is visible.
  int ChooseCurrent() const;
  void MoveTo(int node);
  void Join(int a, int b);
  void AddGhosts(int node);
  bool IsTaken(int node, int direction) const;
  /// Ghosts that a new node makes old news.
  void RemoveVisited(int node);

  GraphSpec spec_;
  std::shared_ptr<SemanticModel> model_;
  TopologicalGraph graph_;
  Localisation here_;
  int misses_ = 0;
  LoopCloser closer_;
  std::vector<sim::PlanarPose> before_;  // this step's move of the nodes; empty: none moved
};

}  // namespace bulletnav::agent
