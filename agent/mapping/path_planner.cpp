// SPDX-License-Identifier: MIT
#include "agent/mapping/path_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr double kSubstituteReach = 1.0;  // metres between a blocked goal and what stands in for it

constexpr double kOnward = 0.5;   // cosine of the angle to the heading
constexpr double kInertia = 0.3;  // metres that the other way must be shorter

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
    : march_(spec.cells()), ahead_(ahead / spec.cell), inertia_(kInertia / spec.cell) {}

std::optional<Waypoint> PathPlanner::Plan(const MetricMap& map, const Query& query) {
  const sim::Grid<sim::CellState>& states = map.states();
  const sim::Cell from = map.CellAt(query.from);
  const sim::Cell wanted = map.CellAt(query.goal);
  if (!states.Contains(wanted)) return std::nullopt;
  const int reach = static_cast<int>(kSubstituteReach / map.spec().cell);
  sim::Cell goal = wanted;
  if (states[goal] == sim::CellState::kBlocked && goal != from) {
    const auto other = NearestUnblocked(states, goal, reach);
    if (!other) return std::nullopt;
    goal = *other;
  }
  march_.Start(states, {goal, query.through_unknown});
  if (!Reach(from)) {
    // It is shut in, as what is not seen of a counter's top.
    march_.Run(states, {from, query.through_unknown});
    const auto other = NearestReached(states, wanted, reach);
    if (!other) return std::nullopt;
    goal = *other;
    march_.Start(states, {goal, query.through_unknown});
    if (!Reach(from)) return std::nullopt;
  }
  const double missing = Distance(wanted, goal);
  const double cell = map.spec().cell;
  const double distance = (march_.distance(from) + missing) * cell;
  if (Distance(from, goal) <= ahead_ && LineCost(states, from, goal)) {
    return Waypoint{map.Centre(goal), distance};
  }
  for (int nearer = 0; ahead_ - nearer >= 1.0; ++nearer) {
    if (const auto best = BestInSight(states, query, from, ahead_ - nearer)) {
      return Waypoint{map.Centre(*best), distance};
    }
  }
  return std::nullopt;
}

std::optional<Point> PathPlanner::PlaceNear(const MetricMap& map, const Query& query,
                                            std::span<const Point> others, double apart) {
  const sim::Cell middle = map.CellAt(query.goal);
  const int reach = static_cast<int>(kSubstituteReach / map.spec().cell);
  march_.Run(map.states(), {map.CellAt(query.from), query.through_unknown});
  const auto is_apart = [&](const Point& place) {
    return std::none_of(others.begin(), others.end(), [&](const Point& other) {
      return Distance(place, other) < apart;
    });
  };
  std::optional<Point> best;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell cell{middle.x + dx, middle.y + dy};
      const Point place = map.Centre(cell);
      const bool is_near = std::hypot(dx, dy) <= reach && map.states().Contains(cell);
      if (!is_near || !std::isfinite(march_.distance(cell))) continue;
      const bool is_nearer = !best || Distance(place, query.goal) < Distance(*best, query.goal);
      if (is_nearer && is_apart(place)) best = place;
    }
  }
  return best;
}

std::optional<sim::Cell> PathPlanner::NearestReached(const sim::Grid<sim::CellState>& states,
                                                     const sim::Cell& cell, int reach) const {
  std::optional<sim::Cell> best;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell other{cell.x + dx, cell.y + dy};
      const bool is_near = std::hypot(dx, dy) <= reach && states.Contains(other);
      if (!is_near || !std::isfinite(march_.distance(other))) continue;
      if (!best || Distance(other, cell) < Distance(*best, cell)) best = other;
    }
  }
  return best;
}

bool PathPlanner::Reach(const sim::Cell& from) {
  while (const auto cell = march_.Next()) {
    if (*cell == from) return true;
  }
  return false;
}

/// On the ring of this radius: the cell over which the way to the goal is shortest.
std::optional<sim::Cell> PathPlanner::BestInSight(const sim::Grid<sim::CellState>& states,
                                                  const Query& query, const sim::Cell& from,
                                                  double radius) const {
  std::optional<sim::Cell> best;
  std::optional<sim::Cell> best_onward;
  double length = std::numeric_limits<double>::infinity();
  double onward_length = length;
  const double ux = query.heading ? sim::Cos(*query.heading) : 0.0;
  const double uy = query.heading ? sim::Sin(*query.heading) : 0.0;
  const int reach = static_cast<int>(std::ceil(radius));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double away = std::hypot(dx, dy);
      const sim::Cell cell{from.x + dx, from.y + dy};
      if (std::fabs(away - radius) > 0.5 || !states.Contains(cell)) continue;
      const bool is_onward = dx * ux + dy * uy >= kOnward * away;
      double* shortest = is_onward && query.heading ? &onward_length : &length;
      if (away + march_.distance(cell) >= *shortest) continue;
      const auto cost = LineCost(states, from, cell);
      if (!cost || *cost + march_.distance(cell) >= *shortest) continue;
      *shortest = *cost + march_.distance(cell);
      (shortest == &length ? best : best_onward) = cell;
    }
  }
  return best_onward && onward_length <= length + inertia_ ? best_onward : best;
}

}  // namespace bulletnav::agent
