// SPDX-License-Identifier: MIT
#include "sim/grid/grid.h"

namespace bulletnav::sim {

std::optional<double> LineCost(const Grid<CellState>& map, const Cell& a, const Cell& b) {
  const int steps = static_cast<int>(std::ceil(2.0 * Distance(a, b)));
  double cost = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Cell at{static_cast<int>(std::lround(a.x + t * (b.x - a.x))),
                  static_cast<int>(std::lround(a.y + t * (b.y - a.y)))};
    if (map[at] == CellState::kBlocked && at != a && at != b) return std::nullopt;
    cost += map[at] == CellState::kTight ? kTightCost : 1.0;
  }
  return steps == 0 ? 0.0 : cost * Distance(a, b) / steps;
}

}  // namespace bulletnav::sim
