// SPDX-License-Identifier: MIT
#include "agent/mapping/frontier.h"

#include <algorithm>

namespace bulletnav::agent {

// Tight cells do not count: the strips along walls that no view reaches lead nowhere.
bool IsFrontier(const sim::Grid<sim::CellState>& map, const sim::Cell& cell) {
  if (map[cell] != sim::CellState::kFree) return false;
  return map[sim::Cell{cell.x - 1, cell.y}] == sim::CellState::kUnknown ||
         map[sim::Cell{cell.x + 1, cell.y}] == sim::CellState::kUnknown ||
         map[sim::Cell{cell.x, cell.y - 1}] == sim::CellState::kUnknown ||
         map[sim::Cell{cell.x, cell.y + 1}] == sim::CellState::kUnknown;
}

FrontierFinder::FrontierFinder(int map_size, int least_cells)
    : march_(map_size), least_cells_(least_cells), marks_(map_size) {}

std::optional<sim::Cell> FrontierFinder::Nearest(const sim::Grid<sim::CellState>& map,
                                                 const sim::Cell& from) {
  Start(map, from);
  while (const auto cell = march_.Next()) {
    if (IsOpening(map, *cell)) return cell;
  }
  return std::nullopt;
}

std::vector<sim::Cell> FrontierFinder::Near(const sim::Grid<sim::CellState>& map,
                                            const sim::Cell& from, double reach, double apart) {
  Start(map, from);
  std::vector<sim::Cell> found;
  while (const auto cell = march_.Next()) {
    if (march_.distance(*cell) > reach) break;
    const bool is_covered = std::any_of(found.begin(), found.end(), [&](const sim::Cell& other) {
      return Distance(*cell, other) < apart;
    });
    if (!is_covered && IsOpening(map, *cell)) found.push_back(*cell);
  }
  return found;
}

void FrontierFinder::Start(const sim::Grid<sim::CellState>& map, const sim::Cell& from) {
  for (const sim::Cell& cell : marked_) marks_[cell] = Mark::kNone;
  marked_.clear();
  march_.Start(map, {from});
}

bool FrontierFinder::IsOpening(const sim::Grid<sim::CellState>& map, const sim::Cell& cell) {
  if (!IsFrontier(map, cell)) return false;
  if (marks_[cell] == Mark::kNone) MarkCluster(map, cell);
  return marks_[cell] == Mark::kLarge;
}

void FrontierFinder::MarkCluster(const sim::Grid<sim::CellState>& map, const sim::Cell& cell) {
  const std::size_t begin = marked_.size();
  const auto mark = [&](const sim::Cell& member) {
    marks_[member] = Mark::kSmall;
    marked_.push_back(member);
  };
  mark(cell);
  for (std::size_t i = begin; i < marked_.size(); ++i) {
    for (int k = 0; k < 9; ++k) {
      const sim::Cell next{marked_[i].x + k % 3 - 1, marked_[i].y + k / 3 - 1};
      if (marks_[next] == Mark::kNone && IsFrontier(map, next)) mark(next);
    }
  }
  if (marked_.size() - begin < static_cast<std::size_t>(least_cells_)) return;
  for (std::size_t i = begin; i < marked_.size(); ++i) marks_[marked_[i]] = Mark::kLarge;
}

}  // namespace bulletnav::agent
