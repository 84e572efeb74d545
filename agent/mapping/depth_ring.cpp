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
      along_x_(cols_),
      along_y_(cols_),
      range_(cols_),
      height_(cols_),
      free_(cols_) {
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
  std::fill(free_.begin(), free_.end(), kNothingSeen);
  TurnColumns(yaw);
  const auto in_x = static_cast<float>(reach_ + x);
  const auto in_y = static_cast<float>(reach_ + y);
  for (int row = 0; row < rows_; ++row) {
    MeasureRow(depth, static_cast<std::size_t>(row));
    CountRow(in_x, in_y);
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

void DepthRing::CountRow(float x, float y) {
  for (std::size_t c = 0; c < cols_; ++c) {
    const float range = range_[c];
    if (!(range > 0.0f)) continue;  // no return, or not a number
    // What is above the body or far away leaves the way to the end of the vision open.
    const bool is_obstacle = height_[c] > low_ && height_[c] < high_ && range <= vision_;
    const float open = is_obstacle ? range : vision_;
    free_[c] = free_[c] == kNothingSeen ? open : std::min(free_[c], open);
    if (range > vision_ || height_[c] >= high_) continue;
    const sim::Cell cell{static_cast<int>(x + range * along_x_[c]),
                         static_cast<int>(y + range * along_y_[c])};
    ++(is_obstacle ? obstacle_points_ : floor_points_)[cell];
    seen_[cell] = 1;
  }
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
