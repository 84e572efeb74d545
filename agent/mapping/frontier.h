// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "sim/grid/fast_marching.h"
#include "sim/grid/grid.h"

namespace bulletnav::agent {

/// Whether a free cell touches an unknown one.
bool IsFrontier(const sim::Grid<sim::CellState>& map, const sim::Cell& cell);

/// Finds where known floor ends. Source: Yamauchi, "A frontier-based approach for autonomous
/// exploration", 1997: greedily the nearest frontier, here by the length of the way to it.
class FrontierFinder {
 public:
  /// Frontiers of fewer than `least_cells` cells are gaps in the view, not openings.
  FrontierFinder(int map_size, int least_cells);

  /// The frontier cell with the shortest way over free cells; absent if all is explored.
  std::optional<sim::Cell> Nearest(const sim::Grid<sim::CellState>& map, const sim::Cell& from);

  /// Frontier cells to which the way is no longer than `reach` cells, the nearest first and no two
  /// nearer to each other than `apart` cells.
  std::vector<sim::Cell> Near(const sim::Grid<sim::CellState>& map, const sim::Cell& from,
                              double reach, double apart);

 private:
  enum class Mark : std::uint8_t { kNone, kSmall, kLarge };

  void Start(const sim::Grid<sim::CellState>& map, const sim::Cell& from);
  /// Whether `cell` is part of a frontier that is large enough.
  bool IsOpening(const sim::Grid<sim::CellState>& map, const sim::Cell& cell);
  /// Marks the frontier that `cell` is part of.
  void MarkCluster(const sim::Grid<sim::CellState>& map, const sim::Cell& cell);

  sim::FastMarching march_;
  int least_cells_;
  sim::Grid<Mark> marks_;
  std::vector<sim::Cell> marked_;
};

}  // namespace bulletnav::agent
