// SPDX-License-Identifier: MIT
#include "agent/mapping/felt_edges.h"

#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr double kNear = 1.5;    // metres between stops at one edge
constexpr int kOften = 8;        // stops that are near
constexpr double kReach = 0.2;   // metres from the body's middle to what stops it
constexpr double kJoined = 0.5;  // metres between places that the body does not fit through
constexpr double kSame = 0.1;    // metres between places that are joined once
constexpr double kBeside = 0.2;  // metres that an edge goes on to both sides

}  // namespace

void FeltEdges::Reset() {
  stops_.clear();
  segments_.clear();
}

bool FeltEdges::Feel(const sim::PlanarPose& pose) {
  stops_.push_back(
      {pose, {pose.x + kReach * sim::Cos(pose.yaw), pose.y + kReach * sim::Sin(pose.yaw)}, false});
  const auto is_near = [&](const Stop& stop) {
    return std::hypot(stop.pose.x - pose.x, stop.pose.y - pose.y) <= kNear;
  };
  if (std::count_if(stops_.begin(), stops_.end(), is_near) < kOften) return false;
  for (Stop& stop : stops_) {
    if (is_near(stop) && !stop.is_edge) Join(&stop);
  }
  return true;
}

void FeltEdges::Join(Stop* stop) {
  const double left_x = -kBeside * sim::Sin(stop->pose.yaw);
  const double left_y = kBeside * sim::Cos(stop->pose.yaw);
  const Point& p = stop->touched;
  segments_.push_back({{p.x - left_x, p.y - left_y}, {p.x + left_x, p.y + left_y}});
  const auto is_same = [&](const Stop& other) {
    return other.is_edge && Distance(other.touched, p) < kSame;
  };
  const bool is_new = std::none_of(stops_.begin(), stops_.end(), is_same);
  for (const Stop& other : stops_) {
    const bool is_joined = other.is_edge && Distance(other.touched, p) <= kJoined;
    if (is_new && is_joined) segments_.push_back({other.touched, p});
  }
  stop->is_edge = true;
}

}  // namespace bulletnav::agent
