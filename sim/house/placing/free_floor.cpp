// SPDX-License-Identifier: MIT
#include "sim/house/placing/free_floor.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim::placing {
namespace {

constexpr float kCell = 0.05f;
constexpr float kBodyMargin = 0.2f;
constexpr float kMouthRadius = 0.12f;
constexpr int kMostCutOff = 60;  // cells, 0.15 m2

}  // namespace

bool Contains(std::span<const PlanPoint> outline, const Rect& rect) {
  constexpr float kTouch = 1e-3f;
  const Rect inner(rect.min() + PlanPoint::Constant(kTouch),
                   rect.max() - PlanPoint::Constant(kTouch));
  if (inner.isEmpty()) return false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Rect edge(outline[i]);
    edge.extend(outline[(i + 1) % outline.size()]);
    if (edge.intersects(inner)) return false;
  }
  return IsInside(outline, inner.center());
}

FreeFloor::FreeFloor(const Room& room, std::vector<PlanPoint> mouths, std::span<const Rect> leaves,
                     float margin)
    : room_(room), mouths_(std::move(mouths)), margin_(margin) {
  Rect bounds;
  for (const PlanPoint& p : room.outline) bounds.extend(p);
  origin_ = bounds.min();
  cols_ = static_cast<int>(std::ceil(bounds.sizes().x() / kCell));
  rows_ = static_cast<int>(std::ceil(bounds.sizes().y() / kCell));
  FindFloor(leaves);
  CloseUnreachable();
  if (IsJoined(open_)) return;
  margin_ = kBodyMargin;
  FindFloor(leaves);
  CloseUnreachable();
  std::vector<char> left = open_;
  if (!mouths_.empty()) Flood(&left);
  std::erase_if(mouths_, [&](const PlanPoint& mouth) {
    return left[static_cast<std::size_t>(CellOf(mouth))] != 0;
  });
}

void FreeFloor::FindFloor(std::span<const Rect> leaves) {
  open_.assign(static_cast<std::size_t>(cols_) * static_cast<std::size_t>(rows_), 0);
  const PlanPoint reach = PlanPoint::Constant(margin_);
  for (int cell = 0; cell < cols_ * rows_; ++cell) {
    const PlanPoint centre = CentreOf(cell);
    const bool is_open = Contains(room_.outline, Rect(centre - reach, centre + reach));
    open_[static_cast<std::size_t>(cell)] = is_open ? 1 : 0;
  }
  for (const Rect& leaf : leaves) Mark(leaf, &open_);
  for (int cell = 0; cell < cols_ * rows_; ++cell) {
    for (const PlanPoint& mouth : mouths_) {
      if ((mouth - CentreOf(cell)).norm() < kMouthRadius) open_[static_cast<std::size_t>(cell)] = 1;
    }
  }
}

void FreeFloor::CloseUnreachable() {
  if (mouths_.empty()) return;
  std::vector<char> left = open_;
  Flood(&left);
  for (const PlanPoint& mouth : mouths_) left[static_cast<std::size_t>(CellOf(mouth))] = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] != 0) open_[i] = 0;
  }
}

int FreeFloor::CellOf(const PlanPoint& point) const {
  const PlanPoint at = (point - origin_) / kCell;
  const int col = std::clamp(static_cast<int>(at.x()), 0, cols_ - 1);
  const int row = std::clamp(static_cast<int>(at.y()), 0, rows_ - 1);
  return row * cols_ + col;
}

PlanPoint FreeFloor::CentreOf(int cell) const {
  const int row = cell / cols_;
  return origin_ +
         kCell * PlanPoint(static_cast<float>(cell % cols_) + 0.5f, static_cast<float>(row) + 0.5f);
}

void FreeFloor::Mark(const Rect& obstacle, std::vector<char>* open) const {
  const PlanPoint reach = PlanPoint::Constant(margin_);
  const int low = CellOf(obstacle.min() - reach);
  const int high = CellOf(obstacle.max() + reach);
  for (int row = low / cols_; row <= high / cols_; ++row) {
    for (int col = low % cols_; col <= high % cols_; ++col) {
      const int cell = row * cols_ + col;
      const bool is_clear = obstacle.exteriorDistance(CentreOf(cell)) >= margin_;
      if (!is_clear) (*open)[static_cast<std::size_t>(cell)] = 0;
    }
  }
}

void FreeFloor::Flood(std::vector<char>* open) const {
  std::vector<int> stack = {CellOf(mouths_.front())};
  while (!stack.empty()) {
    const int cell = stack.back();
    stack.pop_back();
    if ((*open)[static_cast<std::size_t>(cell)] == 0) continue;
    (*open)[static_cast<std::size_t>(cell)] = 0;
    const int col = cell % cols_;
    const int row = cell / cols_;
    if (col > 0) stack.push_back(cell - 1);
    if (col + 1 < cols_) stack.push_back(cell + 1);
    if (row > 0) stack.push_back(cell - cols_);
    if (row + 1 < rows_) stack.push_back(cell + cols_);
  }
}

bool FreeFloor::IsJoined(std::vector<char> open) const {
  if (mouths_.empty()) return true;
  const auto count = [&] {
    return std::count(open.begin(), open.end(), char{1});
  };
  for (const PlanPoint& mouth : mouths_) {
    if (open[static_cast<std::size_t>(CellOf(mouth))] == 0) return false;
  }
  Flood(&open);
  for (const PlanPoint& mouth : mouths_) {
    if (open[static_cast<std::size_t>(CellOf(mouth))] != 0) return false;
  }
  return count() <= kMostCutOff;
}

bool FreeFloor::StaysJoinedWith(const Rect& obstacle) const {
  std::vector<char> open = open_;
  Mark(obstacle, &open);
  return IsJoined(std::move(open));
}

void FreeFloor::Block(const Rect& obstacle) {
  Mark(obstacle, &open_);
}

}  // namespace bulletnav::sim::placing
