// SPDX-License-Identifier: MIT
#include "agent/policy/policy_map.h"

#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kTurnedSide = kMapCoarse * kMapSide;
constexpr int kFirstFine = (kTurnedSide - kMapSide) / 2;
constexpr int kFractionBits = 16;
constexpr unsigned kObstacle = 1;
constexpr unsigned kExplored = 2;
constexpr unsigned kBeen = 4;

/// Nobody plans on it.
MapSpec CropSpec() {
  MapSpec spec;
  spec.dilation_cells = 0;
  spec.clearance_cells = 0;
  return spec;
}

std::int32_t Fixed(double cells) {
  return static_cast<std::int32_t>(std::lround(std::ldexp(cells, kFractionBits)));
}

}  // namespace

PolicyMap::PolicyMap(const Rig& rig)
    : map_(rig, CropSpec()),
      turned_(std::size_t{kTurnedSide} * kTurnedSide),
      bytes_(kPolicyMapBytes) {}

void PolicyMap::Reset() {
  pose_ = {};
  map_.Clear(pose_);
  std::fill(bytes_.begin(), bytes_.end(), std::uint8_t{0});
}

void PolicyMap::See(const Observation& observation) {
  const sim::PlanarPose& moved = observation.odometry;
  if (!std::isfinite(moved.x) || !std::isfinite(moved.y) || !std::isfinite(moved.yaw)) {
    throw sim::Error("the odometry is not finite");
  }
  const sim::PlanarPose before = pose_;
  pose_ = sim::Compose(pose_, moved);
  map_.MarkTrack(before, pose_);
  map_.Update(observation.panorama, pose_);
  Cut();
}

unsigned PolicyMap::BitsOf(const sim::Cell& at) const {
  const int size = map_.states().size();
  if (at.x < 0 || at.y < 0 || at.x >= size || at.y >= size) return 0;
  return (map_.IsObstacle(at) ? kObstacle : 0) | (map_.IsExplored(at) ? kExplored : 0) |
         (map_.IsTrack(at) ? kBeen : 0);
}

/// What lies in cells of 5 cm around the body, in its own frame. In whole numbers, which a step
/// along a row or a column adds to.
void PolicyMap::Turn() {
  const double cell = map_.spec().cell;
  const Point origin = map_.Centre({0, 0});
  const double half = 0.5 * (kTurnedSide - 1);
  const double c = sim::Cos(pose_.yaw);
  const double s = sim::Sin(pose_.yaw);
  // Counted from the map's corner, so that shifting gives the cell that a point is in.
  const double x = (pose_.x - origin.x) / cell + 0.5 + half * (c - s);
  const double y = (pose_.y - origin.y) / cell + 0.5 + half * (s + c);
  const std::int32_t along = Fixed(c);
  const std::int32_t across = Fixed(s);
  std::int32_t row_x = Fixed(x);
  std::int32_t row_y = Fixed(y);
  std::uint8_t* out = turned_.data();
  for (int row = 0; row < kTurnedSide; ++row, row_x -= along, row_y -= across) {
    std::int32_t at_x = row_x;
    std::int32_t at_y = row_y;
    for (int col = 0; col < kTurnedSide; ++col, at_x += across, at_y -= along) {
      *out++ = static_cast<std::uint8_t>(BitsOf({at_x >> kFractionBits, at_y >> kFractionBits}));
    }
  }
}

void PolicyMap::SetBits(int crop, int row, int col, unsigned bits) {
  for (int plane = 0; plane < kMapPlanes; ++plane) {
    const int bit = ((crop * kMapPlanes + plane) * kMapSide + row) * kMapSide + col;
    const unsigned value = (bits >> plane & 1u) << (bit % 8);
    std::uint8_t& byte = bytes_[static_cast<std::size_t>(bit / 8)];
    byte = static_cast<std::uint8_t>(byte | value);
  }
}

void PolicyMap::Cut() {
  Turn();
  std::fill(bytes_.begin(), bytes_.end(), std::uint8_t{0});
  const auto at = [&](int row, int col) {
    return turned_.data() + std::ptrdiff_t{row} * kTurnedSide + col;
  };
  const auto any_at = [&](int row, int col) {
    unsigned any = 0;
    for (int i = 0; i < kMapCoarse; ++i) {
      const std::uint8_t* line = at(kMapCoarse * row + i, kMapCoarse * col);
      any |= unsigned{line[0]} | line[1] | line[2] | line[3];
    }
    return any;
  };
  for (int row = 0; row < kMapSide; ++row) {
    for (int col = 0; col < kMapSide; ++col) {
      SetBits(0, row, col, *at(kFirstFine + row, kFirstFine + col));
      SetBits(1, row, col, any_at(row, col));
    }
  }
}

}  // namespace bulletnav::agent
