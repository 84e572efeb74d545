// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/walk_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using sim::Cell;
using sim::CellState;
using Vec2 = Eigen::Vector2d;

constexpr double kCell = 0.05;
constexpr int kMostCells = 8192;
constexpr int kSnap = 4;  // cells; less than lies between the two sides of a thin wall
/// A navmesh's edges stray from the cells they were made from; without some slack the narrowest
/// passages would close.
constexpr double kSlack = 0.02;
/// Heights of a storey's floor, wider than kSameStorey for the ways between its points; floors one
/// above the other are farther apart.
constexpr double kFloorBand = 0.7;

struct Floor {
  double y = 0.0;
  double area = 0.0;
};

std::vector<Floor> FloorsOf(const sim::Navmesh& navmesh, int island) {
  const auto& corners = navmesh.triangle_corners();
  std::vector<Floor> floors;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    if (navmesh.triangle_islands()[t] != island) continue;
    const auto* c = &corners[3 * t];
    floors.push_back({double{c[0].y() + c[1].y() + c[2].y()} / 3.0,
                      0.5 * double{(c[1] - c[0]).cross(c[2] - c[0]).norm()}});
  }
  std::sort(floors.begin(), floors.end(), [](const Floor& a, const Floor& b) {
    return std::pair(a.y, a.area) < std::pair(b.y, b.area);
  });
  return floors;
}

Vec2 Flat(const Eigen::Vector3f& p) {
  return {p.x(), p.z()};
}

double Cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether a point lies in a triangle or not farther than kSlack outside its edges.
bool IsIn(const std::array<Vec2, 3>& triangle, const Vec2& p) {
  const double sense = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0.0 ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 edge = triangle[(k + 1) % 3] - triangle[k];
    if (sense * Cross(edge, p - triangle[k]) < -kSlack * edge.norm()) return false;
  }
  return true;
}

struct Extent {
  Vec2 low = Vec2::Constant(1e9);
  Vec2 high = Vec2::Constant(-1e9);
  void Add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

bool IsOnStorey(const Eigen::Vector3f* corners, const Storey& storey) {
  const double y = double{corners[0].y() + corners[1].y() + corners[2].y()} / 3.0;
  return std::abs(y - storey.floor_y) <= kFloorBand;
}

/// First corners of the storey's triangles.
std::vector<const Eigen::Vector3f*> TrianglesOf(const sim::Navmesh& navmesh, const Storey& storey) {
  std::vector<const Eigen::Vector3f*> triangles;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    const auto* corners = &navmesh.triangle_corners()[3 * t];
    if (navmesh.triangle_islands()[t] == storey.island && IsOnStorey(corners, storey)) {
      triangles.push_back(corners);
    }
  }
  return triangles;
}

}  // namespace

Storey LargestStorey(const sim::Navmesh& navmesh) {
  BULLETNAV_CHECK(!navmesh.islands().empty());
  const std::vector<Floor> floors = FloorsOf(navmesh, 0);
  Floor best;
  double area = 0.0;
  double moment = 0.0;
  std::size_t first = 0;
  for (std::size_t last = 0; last < floors.size(); ++last) {
    area += floors[last].area;
    moment += floors[last].area * floors[last].y;
    for (; floors[last].y - floors[first].y > kSameStorey; ++first) {
      area -= floors[first].area;
      moment -= floors[first].area * floors[first].y;
    }
    if (area > best.area) best = {moment / area, area};
  }
  return {0, best.y};
}

WalkGrid::WalkGrid(const sim::Navmesh& navmesh, const Storey& storey)
    : storey_(storey), states_(3, sim::CellState::kBlocked) {
  const auto triangles = TrianglesOf(navmesh, storey);
  BULLETNAV_CHECK(!triangles.empty());
  Extent extent;
  for (const auto* corners : triangles) {
    for (int k = 0; k < 3; ++k) extent.Add(Flat(corners[k]));
  }
  // Two cells more on each side: a rim, and room for the slack.
  origin_ = extent.low - Vec2::Constant(2.0 * kCell);
  const double size = std::ceil((extent.high - extent.low).maxCoeff() / kCell) + 4.0;
  if (size > kMostCells) {
    throw sim::Error(
        fmt::format("the scene's floor is {:.0f} m across, too large for labels; is "
                    "its 'scale' right?",
                    size * kCell));
  }
  states_ = sim::Grid<sim::CellState>(static_cast<int>(size), sim::CellState::kBlocked);
  for (const auto* corners : triangles) Rasterise(corners);
}

void WalkGrid::Rasterise(const Eigen::Vector3f* corners) {
  const std::array<Vec2, 3> triangle = {Flat(corners[0]), Flat(corners[1]), Flat(corners[2])};
  Extent extent;
  for (const Vec2& corner : triangle) extent.Add(corner);
  const Vec2 low = (extent.low - origin_) / kCell - Vec2::Ones();
  const Vec2 high = (extent.high - origin_) / kCell + Vec2::Ones();
  const int last = states_.size() - 2;
  for (int y = std::max(1, static_cast<int>(low.y())); y <= std::min<double>(last, high.y()); ++y) {
    for (int x = std::max(1, static_cast<int>(low.x())); x <= std::min<double>(last, high.x());
         ++x) {
      const Vec2 middle = origin_ + kCell * Vec2(x + 0.5, y + 0.5);
      if (IsIn(triangle, middle)) states_[{x, y}] = sim::CellState::kFree;
    }
  }
}

std::optional<sim::Cell> WalkGrid::CellAt(const Eigen::Vector3d& point) const {
  if (std::abs(point.y() - storey_.floor_y) > kFloorBand) return std::nullopt;
  const Vec2 place = (Vec2(point.x(), point.z()) - origin_) / kCell;
  if (!(place.cwiseAbs().maxCoeff() < 2.0 * kMostCells)) return std::nullopt;
  const sim::Cell under = {static_cast<int>(std::floor(place.x())),
                           static_cast<int>(std::floor(place.y()))};
  std::optional<sim::Cell> nearest;
  double least = kSnap;
  for (int y = under.y - kSnap; y <= under.y + kSnap; ++y) {
    for (int x = under.x - kSnap; x <= under.x + kSnap; ++x) {
      const double distance = std::hypot(x + 0.5 - place.x(), y + 0.5 - place.y());
      if (distance >= least || !states_.Contains({x, y})) continue;
      if (states_[{x, y}] != sim::CellState::kFree) continue;
      least = distance;
      nearest = sim::Cell{x, y};
    }
  }
  return nearest;
}

Eigen::Vector3d WalkGrid::Centre(const sim::Cell& cell) const {
  return {origin_.x() + (cell.x + 0.5) * kCell, storey_.floor_y,
          origin_.y() + (cell.y + 0.5) * kCell};
}

void WalkDistances::MeasureFrom(const sim::Cell& from) {
  march_.Run(grid_.states(), {.from = from});
}

double WalkDistances::To(const sim::Cell& cell) const {
  return kCell * double{march_.distance(cell)};
}

}  // namespace bulletnav::bench
