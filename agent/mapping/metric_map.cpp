// SPDX-License-Identifier: MIT
#include "agent/mapping/metric_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agent/mapping/depth_ring.h"
#include "agent/mapping/learned_ring.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kSeenObstacle = 3;     // added to the evidence each time, up to
constexpr int kMostEvidence = 12;    // this; floor seen alone takes 1
constexpr double kWallAhead = 0.15;  // metres
constexpr int kWallThickness = 2;    // cells
constexpr int kSameWall = 2;         // cells between a wall and where the map has it

template <class T>
sim::Grid<T> Moved(const sim::Grid<T>& grid, const sim::Cell& by, const T& fill) {
  sim::Grid<T> moved(grid.size(), fill);
  for (int y = 0; y < grid.size(); ++y) {
    for (int x = 0; x < grid.size(); ++x) {
      const sim::Cell from{x + by.x, y + by.y};
      if (grid.Contains(from)) moved[sim::Cell{x, y}] = grid[from];
    }
  }
  return moved;
}

/// Calls `visit` with points of a line, both ends among them, half a cell apart at most.
template <class Visit>
void AlongLine(const Point& from, const Point& to, double cell, const Visit& visit) {
  const int steps = 1 + static_cast<int>(2.0 * Distance(from, to) / cell);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    visit(Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
  }
}

std::unique_ptr<ViewWindow> MakeView(const Rig& rig, const MapSpec& spec,
                                     std::shared_ptr<FreeSpaceModel> mapper) {
  if (!rig.has_depth) {
    if (mapper) return std::make_unique<LearnedRing>(std::move(mapper), spec);
    throw sim::Error("a metric map needs depth, which this setting has not, or a mapper's weights");
  }
  if (spec.vision >= static_cast<double>(rig.panorama.max_depth_m)) {
    throw sim::Error("the map's vision must be less than the panorama's max_depth_m");
  }
  return std::make_unique<DepthRing>(rig, spec);
}

}  // namespace

MetricMap::MetricMap(const Rig& rig, const MapSpec& spec, std::shared_ptr<FreeSpaceModel> mapper)
    : MetricMap(spec, MakeView(rig, spec, std::move(mapper)), sim::PlanarPose{}) {}

MetricMap::MetricMap(const MapSpec& spec, std::unique_ptr<ViewWindow> view,
                     const sim::PlanarPose& pose)
    : spec_(spec),
      view_(std::move(view)),
      evidence_(spec.cells()),
      explored_(spec.cells()),
      track_(spec.cells()),
      felt_(spec.cells()),
      states_(spec.cells()) {
  Clear(pose);
}

void MetricMap::Clear(const sim::PlanarPose& pose) {
  evidence_.Fill(0);
  explored_.Fill(0);
  track_.Fill(0);
  felt_.Fill(0);
  contradiction_ = {};
  seen_cells_ = 0;
  low_ = {};
  const sim::Cell here = CellAt({pose.x, pose.y});
  low_ = {here.x - states_.size() / 2, here.y - states_.size() / 2};
  Refresh({states_.size() / 2, states_.size() / 2}, states_.size());
  MarkTrack(pose, pose);
}

sim::Cell MetricMap::CellAt(const Point& p) const {
  return {static_cast<int>(std::floor(p.x / spec_.cell)) - low_.x,
          static_cast<int>(std::floor(p.y / spec_.cell)) - low_.y};
}

Point MetricMap::Centre(const sim::Cell& cell) const {
  return {(cell.x + low_.x + 0.5) * spec_.cell, (cell.y + low_.y + 0.5) * spec_.cell};
}

void MetricMap::Update(const Panorama& panorama, const sim::PlanarPose& pose) {
  sim::Cell here = CellAt({pose.x, pose.y});
  const int grown = spec_.dilation_cells + spec_.clearance_cells;
  const int margin = view_->reach() + grown + 2;
  const int last = states_.size() - 1 - margin;
  if (here.x < margin || here.y < margin || here.x > last || here.y > last) {
    MoveTo(here);
    here = CellAt({pose.x, pose.y});
  }
  const double x = pose.x / spec_.cell;
  const double y = pose.y / spec_.cell;
  view_->Project(panorama, x - std::floor(x), y - std::floor(y), pose.yaw);
  Merge(here);
  Refresh(here, view_->reach() + grown);
}

void MetricMap::Merge(const sim::Cell& middle) {
  const int n = view_->seen().size();
  contradiction_ = {};
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (view_->seen()[sim::Cell{x, y}] == 0) continue;
      Contradict({x, y}, {middle.x + x - view_->reach(), middle.y + y - view_->reach()});
      MergeCell({x, y}, {middle.x + x - view_->reach(), middle.y + y - view_->reach()});
    }
  }
}

void MetricMap::Contradict(const sim::Cell& seen, const sim::Cell& cell) {
  const bool is_hit = view_->floor_points()[seen] > 0 || view_->obstacle_points()[seen] > 0;
  if (evidence_[cell] == 0 || !is_hit) return;
  ++contradiction_.all;
  for (int dy = -kSameWall; dy <= kSameWall; ++dy) {
    for (int dx = -kSameWall; dx <= kSameWall; ++dx) {
      const sim::Cell near{seen.x + dx, seen.y + dy};
      const bool is_wall = view_->obstacle_points().Contains(near) &&
                           view_->obstacle_points()[near] >= spec_.obstacle_points;
      if (is_wall) return;
    }
  }
  ++contradiction_.through;
}

void MetricMap::MergeCell(const sim::Cell& seen, const sim::Cell& cell) {
  seen_cells_ += explored_[cell] == 0 ? 1 : 0;
  explored_[cell] = 1;
  std::uint8_t& evidence = evidence_[cell];
  if (view_->obstacle_points()[seen] >= spec_.obstacle_points) {
    evidence = static_cast<std::uint8_t>(std::min(evidence + kSeenObstacle, kMostEvidence));
  } else if (view_->floor_points()[seen] > 0 && view_->obstacle_points()[seen] == 0 &&
             evidence > 0) {
    --evidence;
  }
}

void MetricMap::MoveTo(const sim::Cell& middle) {
  const sim::Cell by{middle.x - states_.size() / 2, middle.y - states_.size() / 2};
  evidence_ = Moved<std::uint8_t>(evidence_, by, 0);
  explored_ = Moved<std::uint8_t>(explored_, by, 0);
  track_ = Moved<std::uint8_t>(track_, by, 0);
  felt_ = Moved<std::uint8_t>(felt_, by, 0);
  low_ = {low_.x + by.x, low_.y + by.y};
  Refresh({states_.size() / 2, states_.size() / 2}, states_.size());
}

void MetricMap::MarkTrack(const sim::PlanarPose& from, const sim::PlanarPose& to) {
  const Point start{from.x, from.y};
  const Point end{to.x, to.y};
  AlongLine(start, end, spec_.cell, [this](const Point& p) {
    const sim::Cell at = CellAt(p);
    for (int k = 0; k < 9; ++k) {
      const sim::Cell cell{at.x + k % 3 - 1, at.y + k / 3 - 1};
      if (!track_.Contains(cell)) continue;
      track_[cell] = 1;
      explored_[cell] = 1;
    }
  });
  Refresh(CellAt(end), 2 + static_cast<int>(Distance(start, end) / spec_.cell));
}

void MetricMap::MarkWall(const sim::PlanarPose& pose, int width_cells) {
  const double c = sim::Cos(pose.yaw);
  const double s = sim::Sin(pose.yaw);
  // Half a cell at a time, so that a wall across the grid has no gaps.
  for (int i = 0; i <= 2 * (kWallThickness - 1); ++i) {
    for (int j = 0; j <= 2 * (width_cells - 1); ++j) {
      const double ahead = kWallAhead + 0.5 * i * spec_.cell;
      const double left = 0.5 * (j - (width_cells - 1)) * spec_.cell;
      const sim::Cell cell = CellAt({pose.x + ahead * c - left * s, pose.y + ahead * s + left * c});
      if (felt_.Contains(cell)) felt_[cell] = 1;
    }
  }
  const int ahead = static_cast<int>(kWallAhead / spec_.cell) + kWallThickness;
  Refresh(CellAt({pose.x, pose.y}), ahead + width_cells + 2);
}

void MetricMap::MarkEdge(const Point& from, const Point& to) {
  AlongLine(from, to, spec_.cell, [this](const Point& p) {
    const sim::Cell at = CellAt(p);
    for (int k = 0; k < kWallThickness * kWallThickness; ++k) {
      const sim::Cell cell{at.x + k % kWallThickness, at.y + k / kWallThickness};
      if (felt_.Contains(cell) && track_[cell] == 0) felt_[cell] = 1;
    }
  });
  const Point middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
  Refresh(CellAt(middle), 3 + static_cast<int>(0.5 * Distance(from, to) / spec_.cell));
}

void MetricMap::ForgetFeltWalls(const Point& p, double radius) {
  SetFelt(p, radius, true, false);
}

void MetricMap::ForgetFeltWalls() {
  felt_.Fill(0);
  Refresh({states_.size() / 2, states_.size() / 2}, states_.size());
}

MapPicture MetricMap::Picture() const {
  MapPicture picture{states_.size(), spec_.cell, low_.x * spec_.cell, low_.y * spec_.cell, {}};
  for (std::size_t i = 0; i < states_.values().size(); ++i) {
    auto kind = explored_[i] != 0 ? MapPicture::Kind::kFree : MapPicture::Kind::kUnknown;
    if (evidence_[i] > 0) kind = MapPicture::Kind::kObstacle;
    if (felt_[i] != 0) kind = MapPicture::Kind::kFeltWall;
    picture.kinds.push_back(kind);
  }
  return picture;
}

void MetricMap::MarkNoWay(const Point& p, double radius) {
  SetFelt(p, radius, false, true);
}

/// Of the cells within `radius` metres, those that are explored or those that are not.
void MetricMap::SetFelt(const Point& p, double radius, bool is_explored, bool is_felt) {
  const sim::Cell middle = CellAt(p);
  const int reach = static_cast<int>(radius / spec_.cell);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell cell{middle.x + dx, middle.y + dy};
      if (!felt_.Contains(cell) || std::hypot(dx, dy) > reach) continue;
      if (IsExplored(cell) == is_explored) felt_[cell] = is_felt ? 1 : 0;
    }
  }
  Refresh(middle, reach);
}

void MetricMap::Refresh(const sim::Cell& middle, int reach) {
  const int last = states_.size() - 1;
  const sim::Cell low{std::max(middle.x - reach, 0), std::max(middle.y - reach, 0)};
  const sim::Cell high{std::min(middle.x + reach, last), std::min(middle.y + reach, last)};
  for (int y = low.y; y <= high.y; ++y) {
    // Plain loops over memory, for compilers.
    const std::size_t row = states_.index({0, y});
    const std::uint8_t* felt = felt_.values().data() + row;
    const std::uint8_t* explored = explored_.values().data() + row;
    sim::CellState* states = &states_[row];
    for (int x = low.x; x <= high.x; ++x) {
      const auto open = explored[x] != 0 ? sim::CellState::kFree : sim::CellState::kUnknown;
      states[x] = felt[x] != 0 ? sim::CellState::kBlocked : open;
    }
    if (low.x == 0) states[0] = OpenState({0, y});
    if (high.x == last) states[last] = OpenState({last, y});
  }
  for (const int y : {0, last}) {
    if (y < low.y || y > high.y) continue;
    for (int x = low.x; x <= high.x; ++x) states_[sim::Cell{x, y}] = OpenState({x, y});
  }
  const int grown = spec_.dilation_cells + spec_.clearance_cells;
  for (int y = std::max(low.y - grown, 0); y <= std::min(high.y + grown, last); ++y) {
    for (int x = std::max(low.x - grown, 0); x <= std::min(high.x + grown, last); ++x) {
      if (evidence_[sim::Cell{x, y}] > 0) GrowObstacle({x, y}, low, high);
    }
  }
}

/// As if there were no obstacles.
sim::CellState MetricMap::OpenState(const sim::Cell& cell) const {
  const int last = states_.size() - 1;
  if (cell.x == 0 || cell.y == 0 || cell.x == last || cell.y == last)
    return sim::CellState::kBlocked;
  if (felt_[cell] != 0) return sim::CellState::kBlocked;
  return explored_[cell] != 0 ? sim::CellState::kFree : sim::CellState::kUnknown;
}

void MetricMap::GrowObstacle(const sim::Cell& obstacle, const sim::Cell& low,
                             const sim::Cell& high) {
  const int hard = spec_.dilation_cells;
  const int soft = hard + spec_.clearance_cells;
  int width = 0;  // of the row of a disc, to either side
  for (int dy = -soft; dy <= soft; ++dy) {
    // It grows to the middle row and shrinks after it.
    while ((width + 1) * (width + 1) + dy * dy <= soft * soft) ++width;
    while (width * width + dy * dy > soft * soft) --width;
    const int y = obstacle.y + dy;
    if (y < low.y || y > high.y) continue;
    const int to = std::min(obstacle.x + width, high.x);
    for (int x = std::max(obstacle.x - width, low.x); x <= to; ++x) {
      sim::CellState& state = states_[sim::Cell{x, y}];
      state = state == sim::CellState::kFree ? sim::CellState::kTight : state;
    }
  }
  for (int y = std::max(obstacle.y - hard, low.y); y <= std::min(obstacle.y + hard, high.y); ++y) {
    for (int x = std::max(obstacle.x - hard, low.x); x <= std::min(obstacle.x + hard, high.x);
         ++x) {
      const int dx = x - obstacle.x;
      const int dy = y - obstacle.y;
      if (dx * dx + dy * dy > hard * hard || track_[sim::Cell{x, y}] != 0) continue;
      states_[sim::Cell{x, y}] = sim::CellState::kBlocked;
    }
  }
}

}  // namespace bulletnav::agent
