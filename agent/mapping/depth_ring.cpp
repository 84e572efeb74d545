// SPDX-License-Identifier: MIT
#include "agent/mapping/depth_ring.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr float kSightStep = 0.7f;  // cells; no ray jumps over a cell
constexpr float kNothingSeen = -1.0f;
constexpr float kSteepest = 0.70f;   // of stairs: their fall by their length, 35 degrees
constexpr float kLeastVoid = 0.20f;  // metres without floor that are more than a gap in a mesh
constexpr float kDropWidth = 0.50f;  // metres beyond its edge that a drop is marked
constexpr double kLeastMet = 0.15;   // of the rays below the horizon

float InCells(const MapSpec& spec) {
  return static_cast<float>(spec.vision / spec.cell);
}

}  // namespace

DepthRing::DepthRing(const Rig& rig, const MapSpec& spec)
    : ViewWindow(static_cast<int>(std::ceil(InCells(spec))) + 1),
      rows_(rig.panorama.rows),
      cols_(static_cast<std::size_t>(rig.panorama.cols)),
      rays_(rig.panorama),
      camera_height_(rig.camera_height),
      vision_(InCells(spec)),
      cell_(static_cast<float>(spec.cell)),
      low_(static_cast<float>(spec.obstacle_low)),
      high_(static_cast<float>(spec.obstacle_high)),
      drop_(static_cast<float>(spec.drop)),
      along_x_(cols_),
      along_y_(cols_),
      range_(cols_),
      height_(cols_),
      free_(cols_),
      floor_height_(cols_),
      floor_range_(cols_),
      edge_range_(cols_),
      drop_range_(cols_) {
  for (std::size_t c = 0; c < cols_; ++c) flat_.push_back(std::hypot(rays_.x[c], rays_.z[c]));
  for (const float up : rays_.y) {
    for (const float flat : flat_) per_metre_.push_back(1.0f / std::hypot(flat, up));
  }
  // Sight lines must lie less than a cell apart where they end, or they leave unseen gaps.
  const double apart = 2.0 * sim::kPi * vision_ / static_cast<double>(cols_);
  rays_per_column_ = static_cast<int>(std::ceil(apart / 0.8));
}

void DepthRing::Project(const Panorama& panorama, double x, double y, double yaw) {
  const std::span<const float> depth = panorama.depth;
  BULLETNAV_CHECK_EQ(depth.size(), static_cast<std::size_t>(rows_) * cols_);
  Clear();
  std::fill(floor_height_.begin(), floor_height_.end(), 0.0f);
  for (auto* none : {&free_, &floor_range_, &edge_range_, &drop_range_}) {
    std::fill(none->begin(), none->end(), kNothingSeen);
  }
  sees_floor_ = SeesFloor(depth);
  TurnColumns(yaw);
  const auto in_x = static_cast<float>(reach_ + x);
  const auto in_y = static_cast<float>(reach_ + y);
  for (auto row = static_cast<std::size_t>(rows_); row-- > 0;) {  // the floor beside the body first
    MeasureRow(depth, row);
    CountRow(row, in_x, in_y);
  }
  LookAlong(in_x, in_y);
}

/// The camera looks along -z with x to the right, the map's x axis points ahead and y to the left.
void DepthRing::TurnColumns(double yaw) {
  const auto c = static_cast<float>(sim::Cos(yaw));
  const auto s = static_cast<float>(sim::Sin(yaw));
  for (std::size_t i = 0; i < cols_; ++i) {
    const float ahead = -rays_.z[i] / flat_[i];
    const float left = -rays_.x[i] / flat_[i];
    along_x_[i] = c * ahead - s * left;
    along_y_[i] = s * ahead + c * left;
  }
}

/// On its own so that the compiler can do several columns at a time.
void DepthRing::MeasureRow(std::span<const float> depth, std::size_t row) {
  const float* d = depth.data() + row * cols_;
  const float* scale = per_metre_.data() + row * cols_;
  const float up = rays_.y[row];
  const float per_cell = 1.0f / cell_;
  for (std::size_t c = 0; c < cols_; ++c) {
    const float t = d[c] * scale[c];
    range_[c] = t * flat_[c] * per_cell;
    height_[c] = camera_height_ + t * up;
  }
}

void DepthRing::CountRow(std::size_t row, float x, float y) {
  const bool looks_down = rays_.y[row] < 0.0f;
  for (std::size_t c = 0; c < cols_; ++c) {
    if (looks_down && IsBelowFloor(c)) {
      LookOverEdge(row, c, x, y);
    } else {
      CountPoint(c, x, y);
    }
  }
}

void DepthRing::CountPoint(std::size_t col, float x, float y) {
  const float range = range_[col];
  if (!(range > 0.0f)) return;  // no return, or not a number
  // What is above the body or far away leaves the way to the end of the vision open.
  const float height = height_[col];
  const bool is_obstacle = height > low_ && height < high_ && range <= vision_;
  EndSight(col, is_obstacle ? range : vision_);
  edge_range_[col] = kNothingSeen;
  drop_range_[col] = kNothingSeen;
  if (range > vision_ || height >= high_) return;
  const sim::Cell cell{static_cast<int>(x + range * along_x_[col]),
                       static_cast<int>(y + range * along_y_[col])};
  ++(is_obstacle ? obstacle_points_ : floor_points_)[cell];
  seen_[cell] = 1;
  if (is_obstacle) return;
  floor_height_[col] = height;
  floor_range_[col] = range;
}

/// Also where nothing is met.
bool DepthRing::IsBelowFloor(std::size_t col) const {
  if (range_[col] > 0.0f) return height_[col] < floor_height_[col] - drop_;
  return range_[col] == 0.0f && sees_floor_;
}

/// Whether enough is met below the horizon for the rest to be no floor: a blind camera sees no
/// drops.
bool DepthRing::SeesFloor(std::span<const float> depth) const {
  std::size_t all = 0;
  std::size_t met = 0;
  for (auto row = static_cast<std::size_t>(rows_); row-- > 0 && rays_.y[row] < 0.0f;) {
    for (const float d : depth.subspan(row * cols_, cols_)) met += d > 0.0f ? 1 : 0;
    all += cols_;
  }
  return static_cast<double>(met) >= kLeastMet * static_cast<double>(all);
}

void DepthRing::LookOverEdge(std::size_t row, std::size_t col, float x, float y) {
  const float down = (camera_height_ - floor_height_[col]) / -rays_.y[row];
  const float crossing = down * flat_[col] / cell_;
  if (!(crossing <= vision_)) return;
  if (edge_range_[col] == kNothingSeen) edge_range_[col] = crossing;
  // The edge lies somewhere below what is seen.
  if (floor_range_[col] == kNothingSeen) EndSight(col, 0.0f);
  if (IsDrop(col, crossing)) {
    MarkDrop(col, crossing, x, y);
  } else if (range_[col] > 0.0f) {
    drop_range_[col] = kNothingSeen;
    EndSight(col, crossing);
  }
}

bool DepthRing::IsDrop(std::size_t col, float crossing) const {
  if (!(range_[col] > 0.0f)) return (crossing - edge_range_[col]) * cell_ >= kLeastVoid;
  const float hidden = range_[col] - std::max(floor_range_[col], 0.0f);
  return floor_height_[col] - height_[col] > kSteepest * hidden * cell_;
}

/// From the last drop of the column to where this ray crosses the floor.
void DepthRing::MarkDrop(std::size_t col, float crossing, float x, float y) {
  float range = drop_range_[col] == kNothingSeen ? edge_range_[col] : drop_range_[col];
  drop_range_[col] = crossing;
  EndSight(col, range);
  const float last = std::min(crossing, edge_range_[col] + kDropWidth / cell_);
  for (; range <= last; range += kSightStep) {
    const sim::Cell cell{static_cast<int>(x + range * along_x_[col]),
                         static_cast<int>(y + range * along_y_[col])};
    ++obstacle_points_[cell];
    seen_[cell] = 1;
  }
}

void DepthRing::EndSight(std::size_t col, float range) {
  free_[col] = free_[col] == kNothingSeen ? range : std::min(free_[col], range);
}

/// Marks what lies between the body and the first obstacle of every column.
void DepthRing::LookAlong(float x, float y) {
  for (std::size_t c = 0; c < cols_; ++c) {
    for (int k = 0; k < rays_per_column_; ++k) {
      MarkSight(x, y, c, static_cast<float>(k) / static_cast<float>(rays_per_column_));
    }
  }
}

void DepthRing::MarkSight(float x, float y, std::size_t col, float towards_next) {
  const std::size_t next = (col + 1) % cols_;
  const float ux = along_x_[col] + towards_next * (along_x_[next] - along_x_[col]);
  const float uy = along_y_[col] + towards_next * (along_y_[next] - along_y_[col]);
  const int steps = static_cast<int>(std::ceil(free_[col] / kSightStep));
  for (int i = 0; i < steps; ++i) {
    const float r = static_cast<float>(i) * kSightStep;
    seen_[{static_cast<int>(x + r * ux), static_cast<int>(y + r * uy)}] = 1;
  }
}

}  // namespace bulletnav::agent
