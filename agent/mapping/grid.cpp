// SPDX-License-Identifier: MIT
#include "agent/mapping/grid.h"

namespace bulletnav::agent {

bool IsLineFree(const Grid<CellState>& map, const Cell& a, const Cell& b) {
  const int steps = static_cast<int>(std::ceil(2.0 * Distance(a, b)));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Cell between{static_cast<int>(std::lround(a.x + t * (b.x - a.x))),
                       static_cast<int>(std::lround(a.y + t * (b.y - a.y)))};
    if (between == a || between == b) continue;
    if (map[between] == CellState::kBlocked) return false;
  }
  return true;
}

}  // namespace bulletnav::agent
