// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sim/math/pose.h"

namespace bulletnav::agent {

/// A picture of an agent's metric map.
struct MapPicture {
  enum class Kind : std::uint8_t { kUnknown, kFree, kObstacle, kFeltWall };

  int size = 0;        // cells a side
  double cell = 0.0;   // metres
  double low_x = 0.0;  // the corner of least coordinates in the agent's plane
  double low_y = 0.0;
  std::vector<Kind> kinds;  // [y, x]
};

/// A picture of an agent's topological graph.
struct GraphPicture {
  struct Node {
    double x = 0.0;
    double y = 0.0;
    bool is_ghost = false;                       // a place not yet visited
    std::optional<double> score = std::nullopt;  // how much speaks for going there, up to 1
    bool operator==(const Node&) const = default;
  };
  std::vector<Node> nodes;
  std::vector<std::pair<int, int>> edges;  // indices of nodes
  std::vector<int> path;  // the agent is on, to where it wants to go; empty if it is on none
};

/// What an agent believes after its last action, for drawing; poses are relative to its start, x
/// ahead and y left. Any part may be missing.
struct Belief {
  std::optional<sim::PlanarPose> pose;
  std::optional<sim::PlanarPose> target;  // where it is heading
  std::optional<MapPicture> map;
  std::optional<GraphPicture> graph = std::nullopt;
};

}  // namespace bulletnav::agent
