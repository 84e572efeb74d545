// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "agent/mapping/fast_marching.h"
#include "agent/mapping/grid.h"

namespace bulletnav::agent {

/// Whether a free cell touches an unknown one.
bool IsFrontier(const Grid<CellState>& map, const Cell& cell);

/// Finds where known floor ends. Source: Yamauchi, "A frontier-based approach for autonomous
/// exploration", 1997: greedily the nearest frontier, here by the length of the way to it.
class FrontierFinder {
 public:
  /// Frontiers of fewer than `least_cells` cells are gaps in the view, not openings.
  FrontierFinder(int map_size, int least_cells);

  /// The frontier cell with the shortest way over free cells; absent if all is explored.
  std::optional<Cell> Nearest(const Grid<CellState>& map, const Cell& from);

 private:
  /// Whether the frontier that `cell` is part of is large enough; marks it as looked at.
  bool IsLarge(const Grid<CellState>& map, const Cell& cell);

  FastMarching march_;
  int least_cells_;
  Grid<std::uint8_t> looked_at_;
  std::vector<Cell> cluster_;
};

}  // namespace bulletnav::agent
