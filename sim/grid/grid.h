// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace bulletnav::sim {

/// A square of a map: column x, row y, from its corner of least coordinates.
struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell&) const = default;
};

inline double Distance(const Cell& a, const Cell& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Square array with one value a cell, row after row.
template <class T>
class Grid {
 public:
  explicit Grid(int size, const T& fill = {})
      : size_(size),
        values_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), fill) {}

  int size() const { return size_; }
  bool Contains(const Cell& c) const { return c.x >= 0 && c.y >= 0 && c.x < size_ && c.y < size_; }
  std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(c.x);
  }
  Cell cell(std::size_t index) const {
    const auto n = static_cast<std::size_t>(size_);
    return {static_cast<int>(index % n), static_cast<int>(index / n)};
  }
  T& operator[](const Cell& c) { return values_[index(c)]; }
  const T& operator[](const Cell& c) const { return values_[index(c)]; }
  T& operator[](std::size_t index) { return values_[index]; }
  const T& operator[](std::size_t index) const { return values_[index]; }
  void Fill(const T& value) { values_.assign(values_.size(), value); }
  const std::vector<T>& values() const { return values_; }

 private:
  int size_;
  std::vector<T> values_;
};

/// What a planner knows of a cell. kTight: free, but so near an obstacle that the body may touch
/// it.
enum class CellState : std::uint8_t { kBlocked, kUnknown, kTight, kFree };

inline bool IsKnownFree(CellState state) {
  return state == CellState::kTight || state == CellState::kFree;
}

/// A cell of a tight place counts as this many.
inline constexpr float kTightCost = 3.0f;

/// Length in cells of the straight line between the middles of two cells, its tight parts counted
/// kTightCost times; absent if it meets a blocked cell. Its ends may be blocked. Looks every half
/// cell.
std::optional<double> LineCost(const Grid<CellState>& map, const Cell& a, const Cell& b);

}  // namespace bulletnav::sim
