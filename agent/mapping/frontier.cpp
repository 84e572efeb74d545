// SPDX-License-Identifier: MIT
#include "agent/mapping/frontier.h"

namespace bulletnav::agent {

// Tight cells do not count: the strips along walls that no view reaches lead nowhere.
bool IsFrontier(const Grid<CellState>& map, const Cell& cell) {
  if (map[cell] != CellState::kFree) return false;
  return map[Cell{cell.x - 1, cell.y}] == CellState::kUnknown ||
         map[Cell{cell.x + 1, cell.y}] == CellState::kUnknown ||
         map[Cell{cell.x, cell.y - 1}] == CellState::kUnknown ||
         map[Cell{cell.x, cell.y + 1}] == CellState::kUnknown;
}

FrontierFinder::FrontierFinder(int map_size, int least_cells)
    : march_(map_size), least_cells_(least_cells), looked_at_(map_size) {}

std::optional<Cell> FrontierFinder::Nearest(const Grid<CellState>& map, const Cell& from) {
  for (const Cell& cell : cluster_) looked_at_[cell] = 0;
  cluster_.clear();
  march_.Start(map, {from});
  while (const auto cell = march_.Next()) {
    if (looked_at_[*cell] != 0 || !IsFrontier(map, *cell)) continue;
    if (IsLarge(map, *cell)) return cell;
  }
  return std::nullopt;
}

bool FrontierFinder::IsLarge(const Grid<CellState>& map, const Cell& cell) {
  const std::size_t begin = cluster_.size();
  cluster_.push_back(cell);
  looked_at_[cell] = 1;
  for (std::size_t i = begin; i < cluster_.size(); ++i) {
    for (int k = 0; k < 9; ++k) {
      const Cell next{cluster_[i].x + k % 3 - 1, cluster_[i].y + k / 3 - 1};
      if (looked_at_[next] != 0 || !IsFrontier(map, next)) continue;
      looked_at_[next] = 1;
      cluster_.push_back(next);
    }
  }
  return cluster_.size() - begin >= static_cast<std::size_t>(least_cells_);
}

}  // namespace bulletnav::agent
