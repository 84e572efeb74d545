// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "agent/models/semantic_model.h"
#include "agent/slam/pose_graph/pose_graph.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// How loops of a topological graph are closed. Metres and probabilities.
struct LoopSpec {
  bool close = false;
  double certainty = 0.99;  // F_L, both ways, from which a node is known again
  double least_way = 10.0;  // walked since the node was made or last known again
  double apart = 1.0;       // between two places that are tied to nodes

  template <class V>
  void Visit(V& v) {
    v("close", close);
    v("certainty", certainty);
    v("least_way", least_way);
    v("apart", apart);
  }
  void Validate() const;
};

/// Keeps the nodes of a topological graph where odometry and what was known again say, as seen from
/// where the body is: its own pose stays that of odometry, nodes of long ago move.
/// Vertices are the nodes and the places where a node was known again. Odometry joins each to the
/// one before, F_R, asked both ways, joins such a place to its node.
/// Source: ours, for Neural Topological SLAM, whose nodes keep the poses that odometry had.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopSpec& spec) : spec_(spec) {}

  void Reset();
  /// Each step; `pose` as the body believes it, by odometry or mended by what it sees.
  void Move(const sim::PlanarPose& pose);
  /// A node was made where the body is. Nodes count from 0.
  void AddNode();
  /// Whether it wants to hear of nodes that are seen here.
  bool IsDue() const;
  /// Whether the body has walked far enough for the node to tell anything new.
  bool IsOld(int node) const;

  /// A node that knows the body again.
  struct Sight {
    int node = 0;
    PairPrediction of_body;  // from the node
    PairPrediction of_node;  // from the body
  };
  /// Where the nodes are, after what is seen has been taken in; absent if nothing was known again.
  std::optional<std::vector<sim::PlanarPose>> Close(std::span<const Sight> sights);

 private:
  /// Pose of the body seen from the node, with how sure it is; absent if the two ways disagree.
  std::optional<PoseEdge<sim::PlanarPose>> EdgeOf(const Sight& sight) const;
  int AddPlace();

  LoopSpec spec_;
  PlanarPoseGraph graph_;
  std::vector<int> nodes_;         // vertices, by node
  std::vector<double> last_tied_;  // way, by node
  int last_ = -1;                  // vertex of the last place
  sim::PlanarPose last_pose_;      // by odometry, there
  sim::PlanarPose pose_;
  double way_ = 0.0;  // metres
  double way_there_ = 0.0;
  double turned_ = 0.0;  // radians since the last place
  double last_loop_ = 0.0;
};

}  // namespace bulletnav::agent
