// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/mapping/metric_map.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Edges that are felt because they are not seen: of a pit whose far side is seen before its depth,
/// of furniture lower than the mapper from colour makes out. Each push marks a wall of a few cells
/// only, and a long edge takes many. Where the body was stopped often, what lies 0.2 m ahead of it
/// then is taken for one edge: places within half a metre of each other are joined, and each goes
/// on a little to both sides. Doors that are hit often may be shut by it. Metres in the agent's
/// plane.
class FeltEdges {
 public:
  struct Segment {
    Point from;
    Point to;
  };

  void Reset();

  /// The body, now at `pose`, was stopped by something ahead of it. True if it was stopped here
  /// often: then segments() has more.
  bool Feel(const sim::PlanarPose& pose);

  const std::vector<Segment>& segments() const { return segments_; }

 private:
  struct Stop {
    sim::PlanarPose pose;
    Point touched;
    bool is_edge = false;
  };

  void Join(Stop* stop);

  std::vector<Stop> stops_;
  std::vector<Segment> segments_;
};

}  // namespace bulletnav::agent
