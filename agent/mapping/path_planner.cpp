// SPDX-License-Identifier: MIT
#include "agent/mapping/path_planner.h"

#include <cmath>
#include <limits>

namespace bulletnav::agent {
namespace {

constexpr double kSubstituteReach = 1.0;  // metres between a blocked goal and what stands in for it

}  // namespace

std::optional<sim::Cell> NearestUnblocked(const sim::Grid<sim::CellState>& states,
                                          const sim::Cell& cell, int reach) {
  std::optional<sim::Cell> best;
  double best_distance = reach + 0.5;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell other{cell.x + dx, cell.y + dy};
      if (!states.Contains(other) || states[other] == sim::CellState::kBlocked) continue;
      if (std::hypot(dx, dy) >= best_distance) continue;
      best_distance = std::hypot(dx, dy);
      best = other;
    }
  }
  return best;
}

PathPlanner::PathPlanner(const MapSpec& spec, double ahead)
    : march_(spec.cells()), ahead_(ahead / spec.cell) {}

std::optional<Waypoint> PathPlanner::Plan(const MetricMap& map, const Query& query) {
  const sim::Grid<sim::CellState>& states = map.states();
  const sim::Cell from = map.CellAt(query.from);
  sim::Cell goal = map.CellAt(query.goal);
  double missing = 0.0;
  if (!states.Contains(goal)) return std::nullopt;
  if (states[goal] == sim::CellState::kBlocked && goal != from) {
    const int reach = static_cast<int>(kSubstituteReach / map.spec().cell);
    const auto other = NearestUnblocked(states, goal, reach);
    if (!other) return std::nullopt;
    missing = Distance(goal, *other);
    goal = *other;
  }
  march_.Start(states, {goal, query.through_unknown});
  if (!Reach(from)) return std::nullopt;
  const double cell = map.spec().cell;
  const double distance = (march_.distance(from) + missing) * cell;
  if (Distance(from, goal) <= ahead_ && LineCost(states, from, goal)) {
    return Waypoint{map.Centre(goal), distance};
  }
  for (int nearer = 0; ahead_ - nearer >= 1.0; ++nearer) {
    if (const auto best = BestInSight(states, from, ahead_ - nearer)) {
      return Waypoint{map.Centre(*best), distance};
    }
  }
  return std::nullopt;
}

bool PathPlanner::Reach(const sim::Cell& from) {
  while (const auto cell = march_.Next()) {
    if (*cell == from) return true;
  }
  return false;
}

/// On the ring of this radius: the cell over which the way to the goal is shortest.
std::optional<sim::Cell> PathPlanner::BestInSight(const sim::Grid<sim::CellState>& states,
                                                  const sim::Cell& from, double radius) const {
  std::optional<sim::Cell> best;
  double best_length = std::numeric_limits<double>::infinity();
  const int reach = static_cast<int>(std::ceil(radius));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double away = std::hypot(dx, dy);
      const sim::Cell cell{from.x + dx, from.y + dy};
      if (std::fabs(away - radius) > 0.5 || !states.Contains(cell)) continue;
      if (away + march_.distance(cell) >= best_length) continue;
      const auto cost = LineCost(states, from, cell);
      if (!cost || *cost + march_.distance(cell) >= best_length) continue;
      best_length = *cost + march_.distance(cell);
      best = cell;
    }
  }
  return best;
}

}  // namespace bulletnav::agent
