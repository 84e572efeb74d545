// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "agent/mapping/metric_map.h"
#include "sim/grid/fast_marching.h"

namespace bulletnav::agent {

/// Where to go next on the way to a goal.
struct Waypoint {
  Point point;            // the short-term goal
  double distance = 0.0;  // metres from here to the goal; tight places count more
};

/// Plans a shortest way over a metric map and takes from it a short-term goal near the body.
/// Source: Active Neural SLAM: fast marching from the goal, then the best cell 25 cm from the body;
/// here only cells in the body's sight count, so that none lies behind a wall.
class PathPlanner {
 public:
  /// `ahead`: metres to the short-term goal.
  PathPlanner(const MapSpec& spec, double ahead);

  struct Query {
    Point from;
    Point goal;  // if it is blocked, the nearest cell that is not stands in for it
    bool through_unknown = false;
  };
  /// Absent if there is no way, or the goal lies outside the map.
  std::optional<Waypoint> Plan(const MetricMap& map, const Query& query);

 private:
  /// Grows the distance from the goal until it knows that of `from`.
  bool Reach(const sim::Cell& from);
  std::optional<sim::Cell> BestInSight(const sim::Grid<sim::CellState>& states,
                                       const sim::Cell& from, double radius) const;

  sim::FastMarching march_;
  double ahead_;  // in cells
};

/// The cell nearest to `cell` that is not blocked, within `reach` cells.
std::optional<sim::Cell> NearestUnblocked(const sim::Grid<sim::CellState>& states,
                                          const sim::Cell& cell, int reach);

}  // namespace bulletnav::agent
