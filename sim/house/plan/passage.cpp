// SPDX-License-Identifier: MIT
#include "sim/house/plan/passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/house/plan/convex.h"

namespace bulletnav::sim::plan {
namespace {

constexpr float kStep = 0.05f;

/// The leaf with half a cell all around, so that no gap opens in its picture.
Quad Thickened(const Quad& leaf) {
  const PlanPoint u = 0.5f * kStep * (leaf[1] - leaf[0]).normalized();
  const PlanPoint v = 0.5f * kStep * (leaf[2] - leaf[1]).normalized();
  return {leaf[0] - u - v, leaf[1] + u - v, leaf[2] + u + v, leaf[3] - u + v};
}

class Raster {
 public:
  explicit Raster(const FloorPlan& plan) : low_(plan.footprint.front()) {
    PlanPoint high = low_;
    for (const PlanPoint& p : plan.footprint) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    columns_ = static_cast<int>((high.x() - low_.x()) / kStep) + 1;
    rows_ = static_cast<int>((high.y() - low_.y()) / kStep) + 1;
    is_open_.assign(Cell(0, rows_), false);
  }

  /// Marks the cells with their centre in a polygon.
  void Fill(std::span<const PlanPoint> polygon, bool is_open) {
    Visit(polygon, [&](int x, int y) {
      is_open_[Cell(x, y)] = is_open;
    });
  }

  /// Where a disc has room.
  std::vector<bool> RoomForDisc(float radius) const {
    const std::vector<std::pair<int, int>> disc = Disc(radius);
    std::vector<bool> room = is_open_;
    const auto stamp = [&](int x, int y) {
      for (const auto& [dx, dy] : disc) {
        if (IsOnRaster(x + dx, y + dy)) room[Cell(x + dx, y + dy)] = false;
      }
    };
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (!is_open_[Cell(x, y)] && HasOpenNeighbour(x, y)) stamp(x, y);
      }
    }
    return room;
  }

  /// Cells connected to the first free one in a polygon.
  std::vector<bool> Flood(const std::vector<bool>& free, std::span<const PlanPoint> start) const {
    std::vector<bool> seen(free.size(), false);
    std::vector<std::pair<int, int>> queue;
    Visit(start, [&](int x, int y) {
      if (queue.empty() && free[Cell(x, y)]) queue.emplace_back(x, y);
    });
    while (!queue.empty()) {
      const auto [x, y] = queue.back();
      queue.pop_back();
      if (!IsOnRaster(x, y) || !free[Cell(x, y)] || seen[Cell(x, y)]) continue;
      seen[Cell(x, y)] = true;
      queue.insert(queue.end(), {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}});
    }
    return seen;
  }

  /// Calls f(x, y) for every cell with its centre in a polygon, row by row.
  template <class F>
  void Visit(std::span<const PlanPoint> polygon, const F& f) const {
    const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(),
                                                 [](const PlanPoint& p, const PlanPoint& q) {
                                                   return p.y() < q.y();
                                                 });
    const int first = std::max(0, Index(low->y() - low_.y()));
    const int last = std::min(rows_ - 1, Index(high->y() - low_.y()));
    for (int y = first; y <= last; ++y) {
      const std::vector<float> crossings = Crossings(polygon, Centre(0, y).y());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) VisitRow(crossings, i, y, f);
    }
  }

  std::size_t Cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

 private:
  static int Index(float metres) { return static_cast<int>(std::floor(metres / kStep)); }

  /// Where the level line at y crosses the polygon's sides, sorted.
  static std::vector<float> Crossings(std::span<const PlanPoint> polygon, float y) {
    std::vector<float> xs;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PlanPoint& p = polygon[i];
      const PlanPoint& q = polygon[(i + 1) % polygon.size()];
      if ((p.y() > y) == (q.y() > y)) continue;
      xs.push_back(p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y()));
    }
    std::sort(xs.begin(), xs.end());
    return xs;
  }

  template <class F>
  void VisitRow(const std::vector<float>& crossings, std::size_t i, int y, const F& f) const {
    const int first = Index(crossings[i] - low_.x() + 0.5f * kStep);
    const int end = Index(crossings[i + 1] - low_.x() + 0.5f * kStep);
    for (int x = std::max(0, first); x < std::min(columns_, end); ++x) f(x, y);
  }

  PlanPoint Centre(int x, int y) const {
    return low_ + kStep * PlanPoint(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  }
  /// Steps to the cells nearer than `radius`.
  static std::vector<std::pair<int, int>> Disc(float radius) {
    const int reach = static_cast<int>(radius / kStep);
    std::vector<std::pair<int, int>> steps;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double distance = std::hypot(dx, dy) * static_cast<double>(kStep);
        if (distance < static_cast<double>(radius)) steps.emplace_back(dx, dy);
      }
    }
    return steps;
  }
  bool IsOnRaster(int x, int y) const { return x >= 0 && y >= 0 && x < columns_ && y < rows_; }
  bool HasOpenNeighbour(int x, int y) const {
    constexpr std::array<std::pair<int, int>, 4> kSteps = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    return std::any_of(kSteps.begin(), kSteps.end(), [&](const auto& step) {
      const int nx = x + step.first;
      const int ny = y + step.second;
      return IsOnRaster(nx, ny) && is_open_[Cell(nx, ny)];
    });
  }

  PlanPoint low_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> is_open_;
};

}  // namespace

bool IsPassable(const FloorPlan& plan, float radius) {
  Raster raster(plan);
  for (const Room& room : plan.rooms) raster.Fill(room.outline, true);
  int entry = 0;
  for (const Opening& o : plan.openings) {
    if (!o.IsPassage()) continue;
    if (o.room_b >= 0) {
      raster.Fill(ApproachZone(o, 0.5f * kStep), true);
    } else {
      entry = o.room_a;
    }
  }
  for (const Opening& o : plan.openings) {
    if (o.has_leaf && o.door_angle > 0.0f) raster.Fill(Thickened(LeafOutline(o)), false);
  }
  for (const Pit& pit : plan.pits) raster.Fill(pit.Outline(), false);
  const std::vector<bool> free = raster.RoomForDisc(radius);
  const auto seen = raster.Flood(free, plan.rooms[static_cast<std::size_t>(entry)].outline);
  return std::all_of(plan.rooms.begin(), plan.rooms.end(), [&](const Room& room) {
    int open = 0;
    int reached = 0;
    raster.Visit(room.outline, [&](int x, int y) {
      open += free[raster.Cell(x, y)] ? 1 : 0;
      reached += seen[raster.Cell(x, y)] ? 1 : 0;
    });
    return reached > 0 && reached > 9 * open / 10;
  });
}

}  // namespace bulletnav::sim::plan
