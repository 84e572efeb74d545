// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/coarse_planner.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::bench {
namespace {

constexpr double kAhead = 2.5;  // cells

int SquaredDistance(const sim::Cell& a, const sim::Cell& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

}  // namespace

CoarsePlanner::CoarsePlanner(int map_cells) : states_(map_cells / 2), march_(map_cells / 2) {}

/// Of four cells the worst.
void CoarsePlanner::Shrink(const agent::MetricMap& map) {
  const sim::CellState* from = map.states().values().data();
  const auto row = static_cast<std::size_t>(map.states().size());
  const auto size = static_cast<std::size_t>(states_.size());
  for (std::size_t y = 0; y < size; ++y) {
    const sim::CellState* above = from + 2 * y * row;
    for (std::size_t x = 0; x < size; ++x) {
      const sim::CellState* left = above + 2 * x;
      states_[y * size + x] =
          std::min(std::min(left[0], left[1]), std::min(left[row], left[row + 1]));
    }
  }
}

sim::Cell CoarsePlanner::CellAt(const agent::MetricMap& map, const agent::Point& point) const {
  const sim::Cell cell = map.CellAt(point);
  const int last = states_.size() - 2;
  return {std::clamp(cell.x / 2, 1, last), std::clamp(cell.y / 2, 1, last)};
}

agent::Point CoarsePlanner::Centre(const agent::MetricMap& map, const sim::Cell& cell) const {
  const agent::Point low = map.Centre({2 * cell.x, 2 * cell.y});
  const double half = 0.5 * map.spec().cell;
  return {low.x + half, low.y + half};
}

void CoarsePlanner::Plan(const agent::MetricMap& map, const agent::Point& from,
                         const agent::Point& goal) {
  Shrink(map);
  const sim::Cell start = CellAt(map, from);
  const sim::Cell wanted = CellAt(map, goal);
  sim::Cell best = start;
  march_.Start(states_, {start, true});
  while (const auto cell = march_.Next()) {
    if (SquaredDistance(*cell, wanted) < SquaredDistance(best, wanted)) best = *cell;
    if (*cell == wanted) break;
  }
  TraceBack(start, best);
}

void CoarsePlanner::TraceBack(const sim::Cell& from, const sim::Cell& to) {
  way_.assign(1, to);
  at_ = 0;
  while (way_.back() != from) {
    const sim::Cell here = way_.back();
    sim::Cell best = here;
    for (int i = 0; i < 9; ++i) {
      const sim::Cell next{here.x + i % 3 - 1, here.y + i / 3 - 1};
      const bool is_nearer = march_.distance(next) < march_.distance(best);
      // Not round the corner of a wall.
      const bool is_free = std::isfinite(march_.distance({next.x, here.y})) &&
                           std::isfinite(march_.distance({here.x, next.y}));
      if (is_nearer && is_free) best = next;
    }
    if (best == here) break;
    way_.push_back(best);
  }
  std::reverse(way_.begin(), way_.end());
}

std::optional<agent::Point> CoarsePlanner::Next(const agent::MetricMap& map,
                                                const agent::Point& from) {
  const sim::Cell here = CellAt(map, from);
  // On along the way as long as that comes nearer, then as far as is in sight.
  while (at_ + 1 < way_.size() &&
         SquaredDistance(way_[at_ + 1], here) <= SquaredDistance(way_[at_], here)) {
    ++at_;
  }
  std::size_t ahead = at_;
  while (ahead + 1 < way_.size() && Distance(way_[ahead], here) < kAhead) ++ahead;
  while (ahead > at_ && !LineCost(states_, here, way_[ahead])) --ahead;
  if (way_.empty() || SquaredDistance(way_[ahead], here) <= 2) return std::nullopt;
  return Centre(map, way_[ahead]);
}

}  // namespace bulletnav::bench
