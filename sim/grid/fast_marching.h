// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/grid/grid.h"

namespace bulletnav::sim {

/// Length of the way from a cell over the passable cells of a map, growing outwards one cell at a
/// time so that a caller stops when it knows enough. Straight ways cost their true length in any
/// direction, not the length of a staircase.
///   march.Start(map, {from});
///   while (const auto cell = march.Next()) { if (wanted(*cell)) ... march.distance(*cell) ... }
/// Lengths are in cells; tight ones count kTightCost times. Cells come in the order of their
/// distance, within an eighth of a cell. Within 4% of the true distance in the open. Source:
/// Sethian's fast marching method, with the untidy queue of Yatziv, Bartesaghi and Sapiro
/// ("O(N) implementation of the fast marching algorithm", 2006) and exact distances near the start.
/// Cost: some tens of nanoseconds a cell reached, nothing for the rest.
class FastMarching {
 public:
  /// A map of `size` x `size` cells.
  explicit FastMarching(int size);

  struct Query {
    Cell from;
    bool through_unknown = false;  // unknown cells are passable
  };
  /// Forgets the last run. The map must not change until the last Next. `from` counts as passable.
  /// Expects: a map of the size, its rim blocked, `from` inside the rim (checked).
  void Start(const Grid<CellState>& map, const Query& query);

  /// The next cell whose distance is known; absent when all that can be reached is done.
  std::optional<Cell> Next();

  /// Start, then Next until all is done.
  void Run(const Grid<CellState>& map, const Query& query);

  /// Infinite where not known yet or never.
  float distance(const Cell& c) const { return settled_[c]; }

 private:
  static constexpr int kBucketsPerCell = 8;
  static constexpr int kBuckets = 64;  // in a ring: distances in the queue differ by less than 8

  bool IsPassable(std::size_t i) const {
    return IsKnownFree((*map_)[i]) || (through_unknown_ && (*map_)[i] == CellState::kUnknown);
  }
  void Offer(std::size_t i, float distance);
  void OfferDisc(const Cell& from);
  void Visit(std::size_t i);
  float Solve(std::size_t i) const;

  const Grid<CellState>* map_ = nullptr;
  bool through_unknown_ = false;
  Grid<float> settled_;
  Grid<float> tentative_;
  std::vector<std::size_t> touched_;
  std::array<std::vector<std::size_t>, kBuckets> buckets_;
  std::size_t queued_ = 0;
  std::int64_t bucket_ = 0;  // counts on beyond kBuckets
};

}  // namespace bulletnav::sim
