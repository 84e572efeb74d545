// SPDX-License-Identifier: MIT
#include "sim/house/plan/draft.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/check.h"

namespace bulletnav::sim::plan {
namespace {

void SortUnique(std::vector<int>* values) {
  std::sort(values->begin(), values->end());
  values->erase(std::unique(values->begin(), values->end()), values->end());
}

int IndexOf(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

bool IsStraight(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
}

void DropStraightCorners(std::vector<GridPoint>* loop) {
  std::vector<GridPoint> corners;
  const std::size_t n = loop->size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!IsStraight((*loop)[(i + n - 1) % n], (*loop)[i], (*loop)[(i + 1) % n])) {
      corners.push_back((*loop)[i]);
    }
  }
  *loop = std::move(corners);
}

}  // namespace

int SnapToGrid(double cm) {
  return kGrid * static_cast<int>(std::lround(cm / kGrid));
}

int Draft::Gross(float metres) const {
  const double cm = 100.0 * static_cast<double>(metres) + wall_cm;
  return kGrid * static_cast<int>(std::ceil(cm / kGrid - 1e-3));
}

Box Draft::Bounds(int room) const {
  const auto& boxes = rooms[static_cast<std::size_t>(room)].boxes;
  BULLETNAV_CHECK(!boxes.empty());
  Box bounds = boxes.front();
  for (const Box& box : boxes) {
    bounds.x0 = std::min(bounds.x0, box.x0);
    bounds.y0 = std::min(bounds.y0, box.y0);
    bounds.x1 = std::max(bounds.x1, box.x1);
    bounds.y1 = std::max(bounds.y1, box.y1);
  }
  return bounds;
}

CellGrid::CellGrid(const Draft& draft) {
  for (const DraftRoom& room : draft.rooms) {
    for (const Box& box : room.boxes) {
      xs_.insert(xs_.end(), {box.x0, box.x1});
      ys_.insert(ys_.end(), {box.y0, box.y1});
    }
  }
  SortUnique(&xs_);
  SortUnique(&ys_);
  cells_.assign(Index(0, rows()), kOutside);
  for (std::size_t i = 0; i < draft.rooms.size(); ++i) {
    for (const Box& box : draft.rooms[i].boxes) Mark(box, static_cast<int>(i));
  }
}

void CellGrid::Mark(const Box& box, int room) {
  for (int row = IndexOf(ys_, box.y0); row < IndexOf(ys_, box.y1); ++row) {
    for (int column = IndexOf(xs_, box.x0); column < IndexOf(xs_, box.x1); ++column) {
      int& owner = cells_[Index(column, row)];
      if (owner != kOutside) overlaps_ = true;
      owner = room;
    }
  }
}

int CellGrid::Cell(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns() || row >= rows()) return kOutside;
  return cells_[Index(column, row)];
}

int CellGrid::RoomAt(int x, int y) const {
  return Cell(IndexOf(xs_, x) - 1, IndexOf(ys_, y) - 1);
}

bool CellGrid::HasPinches() const {
  for (int r = 0; r <= rows(); ++r) {
    for (int c = 0; c <= columns(); ++c) {
      const int a = Cell(c - 1, r - 1);
      const int b = Cell(c, r - 1);
      const int d = Cell(c - 1, r);
      const int e = Cell(c, r);
      if ((a == e && a != b && a != d) || (b == d && b != a && b != e)) return true;
    }
  }
  return false;
}

void CellGrid::AddLine(bool is_vertical, int line, std::vector<Border>* borders) const {
  const int at = (is_vertical ? xs_ : ys_)[static_cast<std::size_t>(line)];
  const std::vector<int>& steps = is_vertical ? ys_ : xs_;
  bool is_open = false;  // the last border can be made longer
  for (int step = 0; step + 1 < static_cast<int>(steps.size()); ++step) {
    const int low = is_vertical ? Cell(line - 1, step) : Cell(step, line - 1);
    const int high = is_vertical ? Cell(line, step) : Cell(step, line);
    const auto s = static_cast<std::size_t>(step);
    if (low == high) {
      is_open = false;
    } else if (is_open && borders->back().low == low && borders->back().high == high) {
      borders->back().to = steps[s + 1];
    } else {
      borders->push_back({is_vertical, at, steps[s], steps[s + 1], low, high});
      is_open = true;
    }
  }
}

std::vector<Border> CellGrid::Borders() const {
  std::vector<Border> borders;
  for (int line = 0; line <= columns(); ++line) AddLine(true, line, &borders);
  for (int line = 0; line <= rows(); ++line) AddLine(false, line, &borders);
  return borders;
}

std::vector<GridPoint> CellGrid::Outline(const std::function<bool(int)>& is_inside) const {
  std::map<GridPoint, GridPoint> next;
  for (int r = 0; r < rows(); ++r) {
    for (int c = 0; c < columns(); ++c) {
      if (!is_inside(Cell(c, r))) continue;
      const GridPoint a{xs_[static_cast<std::size_t>(c)], ys_[static_cast<std::size_t>(r)]};
      const GridPoint b{xs_[static_cast<std::size_t>(c) + 1], ys_[static_cast<std::size_t>(r) + 1]};
      // Down the left side, along the bottom, up the right side and back: the inside is to the
      // left.
      if (!is_inside(Cell(c - 1, r))) next[a] = {a.x, b.y};
      if (!is_inside(Cell(c, r + 1))) next[{a.x, b.y}] = b;
      if (!is_inside(Cell(c + 1, r))) next[b] = {b.x, a.y};
      if (!is_inside(Cell(c, r - 1))) next[{b.x, a.y}] = a;
    }
  }
  if (next.empty()) return {};
  std::vector<GridPoint> loop;
  for (GridPoint p = next.begin()->first; loop.empty() || p != loop.front(); p = next.at(p)) {
    loop.push_back(p);
    if (loop.size() > next.size()) return {};
  }
  if (loop.size() != next.size()) return {};
  DropStraightCorners(&loop);
  return loop;
}

}  // namespace bulletnav::sim::plan
