// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/viewshed.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr float kStep = 0.7f;   // cells; no ray jumps over one
constexpr int kRowsBelow = 64;  // the horizon, a bit each
constexpr std::uint64_t kAll = ~std::uint64_t{0};

std::uint64_t FirstRows(int count) {
  return count >= kRowsBelow ? kAll : (std::uint64_t{1} << count) - 1;
}

int Reach(const agent::MapSpec& spec) {
  if (spec.cell != HeightColumns::kCell) {
    throw sim::Error("a simulated view needs maps with cells of 0.05 m");
  }
  if (spec.vision > 3.9) throw sim::Error("a simulated view sees no farther than 3.9 m");
  return static_cast<int>(std::ceil(spec.vision / spec.cell)) + 1;
}

/// How many of the rows below the horizon are no more than `drop` metres below the camera.
int RowsAbove(double drop, double fall) {
  int count = 0;
  while (count < kRowsBelow && fall * (count + 0.5) <= drop) ++count;
  return count;
}

}  // namespace

Viewshed::Viewshed(const agent::MapSpec& spec, double camera_height)
    : ViewWindow(Reach(spec)),
      obstacle_bit_(static_cast<int>(std::lround(spec.obstacle_low / spec.cell))) {
  const double slope = 2.0 * sim::kPi / kColumns;  // from row to row
  for (float range = 0.0f; range <= static_cast<float>(spec.vision / spec.cell); range += kStep) {
    range_.push_back(range);
    Rows& rows = above_.emplace_back();
    const double fall = slope * double{range} * spec.cell;  // from row to row
    for (std::size_t bit = 0; bit < rows.size(); ++bit) {
      rows[bit] = FirstRows(RowsAbove(camera_height - static_cast<double>(bit) * spec.cell, fall));
    }
  }
  for (int i = 0; i < kColumns; ++i) {
    // Column 0 looks behind, columns go clockwise.
    const double bearing = sim::kPi - (i + 0.5) * slope;
    ahead_.push_back(sim::Cos(bearing));
    left_.push_back(sim::Sin(bearing));
  }
}

void Viewshed::Place(const HeightColumns* columns, const sim::BodyPose& pose, SeenGround* seen) {
  BULLETNAV_CHECK_EQ(seen->cells.size(), columns->values().size());
  columns_ = columns;
  pose_ = pose;
  ground_ = seen;
  x_ = static_cast<float>(columns->AlongX(pose.position.x()));
  z_ = static_cast<float>(columns->AlongZ(pose.position.z()));
}

void Viewshed::Project(const agent::Panorama& /*panorama*/, double x, double y, double yaw) {
  Clear();
  if (columns_ == nullptr || !columns_->IsInside(double{x_}, double{z_})) return;
  const double c = sim::Cos(yaw);
  const double s = sim::Sin(yaw);
  const Eigen::Vector3d forward = pose_.forward();
  const Eigen::Vector3d left = pose_.left();
  const auto map_x = static_cast<float>(reach_ + x);
  const auto map_y = static_cast<float>(reach_ + y);
  for (std::size_t i = 0; i < ahead_.size(); ++i) {
    const double a = ahead_[i];
    const double l = left_[i];
    Look({static_cast<float>(a * forward.x() + l * left.x()),
          static_cast<float>(a * forward.z() + l * left.z()), static_cast<float>(a * c - l * s),
          static_cast<float>(a * s + l * c)},
         map_x, map_y);
  }
}

void Viewshed::See(std::size_t ground) {
  std::uint8_t& cell = ground_->cells[ground];
  if (cell != 0) return;
  cell = 1;
  ++ground_->count;
  ground_->weight += ground_->weights.empty() ? 1.0 : double{ground_->weights[ground]};
}

void Viewshed::Look(const Ray& ray, float map_x, float map_y) {
  const auto width = static_cast<std::size_t>(columns_->width());
  const auto window = static_cast<std::size_t>(seen_.size());
  std::uint64_t alive = kAll;
  bool is_open = true;  // nothing that is in the body's way has been met
  for (std::size_t i = 0; i < range_.size() && (is_open || alive != 0); ++i) {
    const float range = range_[i];
    const std::size_t ground = static_cast<std::size_t>(z_ + range * ray.z) * width +
                               static_cast<std::size_t>(x_ + range * ray.x);
    const std::size_t cell = static_cast<std::size_t>(map_y + range * ray.map_y) * window +
                             static_cast<std::size_t>(map_x + range * ray.map_x);
    const std::uint32_t column = columns_->values()[ground];
    const std::uint64_t before = alive;
    if (is_open) seen_[cell] = 1;
    const bool was_open = is_open;
    if (column > 1) Meet(column, above_[i], cell, &alive, &is_open);
    const std::uint64_t low = alive & ~above_[i][0];
    if ((column & 1) != 0 && low != 0) {
      floor_points_[cell] = static_cast<std::uint16_t>(floor_points_[cell] + std::popcount(low));
    }
    alive &= above_[i][0];  // without a floor they are lost
    const bool is_met = (column & 1) != 0 ? before != alive : (before & above_[i][0]) != alive;
    if (is_met) seen_[cell] = 1;
    if (is_met || was_open) See(ground);
  }
}

/// Rays that meet what stands on a cell.
void Viewshed::Meet(std::uint32_t column, const Rows& above, std::size_t cell, std::uint64_t* alive,
                    bool* is_open) {
  for (std::uint32_t rest = column & ~1u; rest != 0;) {
    const int from = std::countr_zero(rest);
    int to = from + std::countr_one(rest >> from);
    if (from < obstacle_bit_) to = std::min(to, obstacle_bit_);
    rest &= ~((std::uint32_t{1} << to) - 1);
    const std::uint64_t met =
        *alive & above[static_cast<std::size_t>(from)] & ~above[static_cast<std::size_t>(to)];
    if (met == 0) continue;
    const bool is_obstacle = from >= obstacle_bit_;
    std::uint16_t& points = (is_obstacle ? obstacle_points_ : floor_points_)[cell];
    points = static_cast<std::uint16_t>(points + std::popcount(met));
    *alive &= ~met;
    if (is_obstacle) *is_open = false;
  }
}

}  // namespace bulletnav::bench
