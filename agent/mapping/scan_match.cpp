// SPDX-License-Identifier: MIT
#include "agent/mapping/scan_match.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr int kRounds = 8;
constexpr double kFirstGate = 0.5;  // metres between a point and its line, in the first rounds
constexpr double kLastGate = 0.1;
constexpr double kOffLine = 0.02;               // metres: how well points lie on lines,
constexpr double kOffOdometry = 0.05;           // and how far the odometry of a step may be off,
constexpr double kTurned = sim::DegToRad(2.0);  // and turned
constexpr double kLeastShare = 0.25;            // of the columns must fit
constexpr double kGap = 0.25;                   // metres between neighbours on one surface
constexpr double kFarthest = 8.0;               // metres
constexpr double kMostOff = 0.3;                // metres and radians from the odometry

}  // namespace

ScanMatch::ScanMatch(const Rig& rig) {
  const sim::RayGrid rays(rig.panorama);
  for (std::size_t r = 1; r < rays.y.size(); ++r) {
    if (std::fabs(rays.y[r]) < std::fabs(rays.y[row_])) row_ = r;
  }
  for (std::size_t c = 0; c < rays.x.size(); ++c) {
    const double x = rays.x[c];
    const double z = rays.z[c];
    const double flat = std::hypot(x, z);
    bearing_.push_back(sim::Atan2(-x, -z));
    level_.push_back(flat / std::hypot(flat, static_cast<double>(rays.y[row_])));
  }
}

std::vector<ScanMatch::Seen> ScanMatch::Scan(std::span<const float> depth) const {
  const std::size_t cols = bearing_.size();
  BULLETNAV_CHECK(depth.size() >= (row_ + 1) * cols);
  std::vector<Seen> seen(cols);
  for (std::size_t c = 0; c < cols; ++c) {
    const double range = static_cast<double>(depth[row_ * cols + c]) * level_[c];
    if (!(range > 0.0 && range < kFarthest)) continue;
    seen[c] = {range * sim::Cos(bearing_[c]), range * sim::Sin(bearing_[c]), range};
  }
  return seen;
}

std::size_t ScanMatch::ColumnAt(double bearing) const {
  const auto after = std::lower_bound(bearing_.begin(), bearing_.end(), bearing, std::greater<>());
  if (after == bearing_.begin()) return 0;
  if (after == bearing_.end()) return bearing_.size() - 1;
  const bool is_nearer = *(after - 1) - bearing < bearing - *after;
  return static_cast<std::size_t>(after - bearing_.begin()) - (is_nearer ? 1 : 0);
}

bool ScanMatch::FindLine(const Seen& point, double gate, Line* line) const {
  const std::size_t cols = last_.size();
  const std::size_t c = ColumnAt(sim::Atan2(point.y, point.x));
  const Seen& middle = last_[c];
  const Seen& a = last_[(c + cols - 1) % cols];
  const Seen& b = last_[(c + 1) % cols];
  if (middle.range == 0.0 || a.range == 0.0 || b.range == 0.0) return false;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  if (!(length > 1e-6 && length < 2.0 * kGap)) return false;
  line->x = -dy / length;
  line->y = dx / length;
  line->off = line->x * (point.x - middle.x) + line->y * (point.y - middle.y);
  return std::fabs(line->off) <= gate;
}

bool ScanMatch::Improve(const std::vector<Seen>& now, const sim::PlanarPose& odometry, double gate,
                        sim::PlanarPose* motion) const {
  const double c = sim::Cos(motion->yaw);
  const double s = sim::Sin(motion->yaw);
  const Eigen::Vector3d off(motion->x - odometry.x, motion->y - odometry.y,
                            sim::WrapAngle(motion->yaw - odometry.yaw));
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  square(0, 0) = square(1, 1) = kOffLine * kOffLine / (kOffOdometry * kOffOdometry);
  square(2, 2) = kOffLine * kOffLine / (kTurned * kTurned);
  Eigen::Vector3d right = -(square * off);
  int fitting = 0;
  for (const Seen& p : now) {
    if (p.range == 0.0) continue;
    const double turned_x = c * p.x - s * p.y;
    const double turned_y = s * p.x + c * p.y;
    Line line;
    if (!FindLine({motion->x + turned_x, motion->y + turned_y, 0.0}, gate, &line)) continue;
    const Eigen::Vector3d change(line.x, line.y, line.y * turned_x - line.x * turned_y);
    square += change * change.transpose();
    right -= line.off * change;
    ++fitting;
  }
  const Eigen::Vector3d by = square.ldlt().solve(right);
  *motion = {motion->x + by.x(), motion->y + by.y(), sim::WrapAngle(motion->yaw + by.z())};
  return fitting >= kLeastShare * static_cast<double>(now.size());
}

sim::PlanarPose ScanMatch::Match(const Panorama& panorama, const sim::PlanarPose& odometry) {
  std::vector<Seen> now = Scan(panorama.depth);
  sim::PlanarPose motion = odometry;
  bool fits = !last_.empty();
  for (int i = 0; fits && i < kRounds; ++i) {
    fits = Improve(now, odometry, i < kRounds / 2 ? kFirstGate : kLastGate, &motion);
  }
  last_ = std::move(now);
  const bool is_near = std::hypot(motion.x - odometry.x, motion.y - odometry.y) <= kMostOff &&
                       std::fabs(sim::WrapAngle(motion.yaw - odometry.yaw)) <= kMostOff;
  return fits && is_near ? motion : odometry;
}

}  // namespace bulletnav::agent
