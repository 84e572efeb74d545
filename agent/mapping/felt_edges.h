// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "agent/mapping/metric_map.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// What is felt and not seen: the edge of a pit whose far side is seen before its depth, furniture
/// lower than the mapper from colour makes out. Each push marks a wall of a few cells, so that a
/// long edge is pushed at all along. Where the body was stopped often, what it touched is taken for
/// one edge: between places that the body does not fit through, and on to both sides of each.
/// Metres in the agent's plane.
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
