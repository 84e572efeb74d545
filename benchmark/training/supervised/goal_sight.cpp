// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/goal_sight.h"

#include <algorithm>
#include <cmath>

#include "agent/models/semantic_model.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

constexpr double kHalfPatch = sim::DegToRad(2.5);
/// Nearer to straight up or down than a panorama shows; for goals almost at the source.
constexpr double kSteepest = 1.0;

}  // namespace

GoalSight::GoalSight(const sim::PanoramaSpec& spec) : rays_(spec), half_width_(kHalfPatch) {
  for (std::size_t c = 0; c < rays_.x.size(); ++c) {
    bearing_.push_back(sim::Atan2(-rays_.x[c], -rays_.z[c]));
    flat_.push_back(std::hypot(rays_.x[c], rays_.z[c]));
  }
  // Coarse pictures have to show something of every patch.
  half_width_ = std::max(half_width_, sim::kPi / spec.cols);
}

bool GoalSight::IsSameNode(std::span<const float> depth, const sim::PlanarPose& goal,
                           double rise) const {
  const double distance = std::hypot(goal.x, goal.y);
  if (distance > agent::kNodeRadius) return false;
  const double elevation = distance > 0.0 ? rise / distance : 0.0;
  return FarthestRange(depth, sim::Atan2(goal.y, goal.x), elevation) > distance;
}

double GoalSight::FarthestRange(std::span<const float> depth, double bearing,
                                double elevation) const {
  BULLETNAV_CHECK_EQ(depth.size(), rays_.x.size() * rays_.y.size());
  const double middle = sim::Atan(std::clamp(elevation, -kSteepest, kSteepest));
  const Patch patch = {bearing, sim::Tan(middle - kHalfPatch), sim::Tan(middle),
                       sim::Tan(middle + kHalfPatch)};
  double farthest = 0.0;
  for (std::size_t c = 0; c < bearing_.size(); ++c) {
    if (std::abs(sim::WrapAngle(bearing_[c] - bearing)) > half_width_) continue;
    farthest = std::max(farthest, FarthestInColumn(depth, c, patch));
  }
  return farthest;
}

std::size_t GoalSight::MiddleRow(std::size_t col, const Patch& patch) const {
  const auto off = [&](float y) {
    return std::abs(double{y} / flat_[col] - patch.middle);
  };
  const auto nearest = std::min_element(rays_.y.begin(), rays_.y.end(), [&](float a, float b) {
    return off(a) < off(b);
  });
  return static_cast<std::size_t>(nearest - rays_.y.begin());
}

double GoalSight::FarthestInColumn(std::span<const float> depth, std::size_t col,
                                   const Patch& patch) const {
  const std::size_t middle = MiddleRow(col, patch);
  double farthest = 0.0;
  for (std::size_t r = 0; r < rays_.y.size(); ++r) {
    const double slope = double{rays_.y[r]} / flat_[col];
    if (r != middle && (slope < patch.low || slope > patch.high)) continue;
    const double range = double{depth[r * rays_.x.size() + col]} / std::hypot(1.0, slope);
    farthest = std::max(farthest, range);
  }
  return farthest;
}

}  // namespace bulletnav::bench
