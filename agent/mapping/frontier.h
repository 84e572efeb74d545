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

  /// Frontier cells to which the way is no longer than `reach` cells, the nearest first and no two
  /// nearer to each other than `apart` cells.
  std::vector<Cell> Near(const Grid<CellState>& map, const Cell& from, double reach, double apart);

 private:
  enum class Mark : std::uint8_t { kNone, kSmall, kLarge };

  void Start(const Grid<CellState>& map, const Cell& from);
  /// Whether `cell` is part of a frontier that is large enough.
  bool IsOpening(const Grid<CellState>& map, const Cell& cell);
  /// Marks the frontier that `cell` is part of.
  void MarkCluster(const Grid<CellState>& map, const Cell& cell);

  FastMarching march_;
  int least_cells_;
  Grid<Mark> marks_;
  std::vector<Cell> marked_;
};

}  // namespace bulletnav::agent
