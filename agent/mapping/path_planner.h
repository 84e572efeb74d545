// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

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
    Point goal;  // if it is blocked or shut in, the nearest cell that is not stands in for it
    bool through_unknown = false;
    /// The way that the body is on: of two ways nearly as long, as those around the two ends of a
    /// counter, the one that goes on in this direction is taken. Radians in the map.
    std::optional<double> heading = std::nullopt;
  };
  /// Absent if there is no way, or the goal lies outside the map.
  std::optional<Waypoint> Plan(const MetricMap& map, const Query& query);

  /// The place nearest to a goal, a metre from it at most and `apart` metres from all `others`, to
  /// which there is a way.
  std::optional<Point> PlaceNear(const MetricMap& map, const Query& query,
                                 std::span<const Point> others, double apart);

 private:
  /// Grows the distance from the goal until it knows that of `from`.
  bool Reach(const sim::Cell& from);
  /// The cell nearest to another, within `reach` cells, whose distance is known.
  std::optional<sim::Cell> NearestReached(const sim::Grid<sim::CellState>& states,
                                          const sim::Cell& cell, int reach) const;
  std::optional<sim::Cell> BestInSight(const sim::Grid<sim::CellState>& states, const Query& query,
                                       const sim::Cell& from, double radius) const;

  sim::FastMarching march_;
  double ahead_;    // in cells
  double inertia_;  // in cells
};

/// The cell nearest to `cell` that is not blocked, within `reach` cells.
std::optional<sim::Cell> NearestUnblocked(const sim::Grid<sim::CellState>& states,
                                          const sim::Cell& cell, int reach);

}  // namespace bulletnav::agent
