// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bulletnav::agent {

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

/// What a planner knows of a cell.
enum class CellState : std::uint8_t { kBlocked, kUnknown, kFree };

/// Whether the straight line between the middles of two cells keeps off blocked cells; its ends do
/// not count. Looks every half cell.
bool IsLineFree(const Grid<CellState>& map, const Cell& a, const Cell& b);

}  // namespace bulletnav::agent
