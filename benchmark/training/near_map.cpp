// SPDX-License-Identifier: MIT
#include "benchmark/training/near_map.h"

#include <cmath>
#include <limits>

#include "agent/perception/semantic_model.h"
#include "benchmark/training/labels.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using agent::Cell;
using agent::CellState;

constexpr double kLongestWay = 1.05 * agent::kNodeRadius;
constexpr double kRoundingSlack = 0.01;  // cells: a radius in single precision is no whole number

}  // namespace

NearMap::NearMap(const agent::Rig& rig, double body_radius)
    : ring_(rig, spec_),
      body_(static_cast<int>(std::ceil(body_radius / spec_.cell - kRoundingSlack))),
      middle_{ring_.reach(), ring_.reach()},
      states_(2 * ring_.reach() + 1),
      march_(states_.size()) {
  if (double{rig.panorama.max_depth_m} < spec_.vision) {
    throw sim::Error("labels need a panorama whose max_depth_m is at least 3.2");
  }
}

void NearMap::Project(std::span<const float> depth) {
  ring_.Project(depth, 0.5, 0.5, 0.0);
  states_.Fill(CellState::kBlocked);
  const int last = states_.size() - 1;
  for (int y = 1; y < last; ++y) {
    for (int x = 1; x < last; ++x) {
      if (ring_.seen()[{x, y}] != 0) states_[{x, y}] = CellState::kFree;
    }
  }
  const double reach = agent::kNodeRadius / spec_.cell;
  for (int y = 1; y < last; ++y) {
    for (int x = 1; x < last; ++x) {
      const bool is_obstacle = ring_.obstacle_points()[{x, y}] >= spec_.obstacle_points;
      if (is_obstacle && Distance({x, y}, middle_) <= reach) BlockAround({x, y});
    }
  }
  FreeMiddle();
  march_.Start(states_, {.from = middle_});
  while (march_.Next()) {
  }
}

void NearMap::BlockAround(const Cell& obstacle) {
  for (int dy = -body_; dy <= body_; ++dy) {
    for (int dx = -body_; dx <= body_; ++dx) {
      const Cell cell{obstacle.x + dx, obstacle.y + dy};
      if (dx * dx + dy * dy <= body_ * body_ && states_.Contains(cell)) {
        states_[cell] = CellState::kBlocked;
      }
    }
  }
}

/// Growing obstacles by whole cells must not wall in a body that stands close to them.
void NearMap::FreeMiddle() {
  for (int dy = -body_; dy <= body_; ++dy) {
    for (int dx = -body_; dx <= body_; ++dx) {
      if (dx * dx + dy * dy > body_ * body_) continue;
      states_[{middle_.x + dx, middle_.y + dy}] = CellState::kFree;
    }
  }
}

Cell NearMap::CellAlong(int direction, double distance) const {
  const double bearing = BearingOf(direction);
  const double cells = distance / spec_.cell;
  return {middle_.x + static_cast<int>(std::lround(cells * std::cos(bearing))),
          middle_.y + static_cast<int>(std::lround(cells * std::sin(bearing)))};
}

bool NearMap::IsExplorable(int direction) const {
  return WayTo(direction) < kLongestWay;
}

double NearMap::WayTo(int direction) const {
  const Cell target = CellAlong(direction, agent::kNodeRadius);
  if (states_[target] != CellState::kFree) return std::numeric_limits<double>::infinity();
  // A straight way has its exact length, without the march's error.
  if (const auto straight = LineCost(states_, middle_, target)) return *straight * spec_.cell;
  return double{march_.distance(target)} * spec_.cell;
}

double NearMap::Reach(int direction) const {
  const double farthest = agent::kNodeRadius / spec_.cell;
  for (double cells = farthest; cells > 0.5; cells -= 1.0) {
    const Cell cell = CellAlong(direction, cells * spec_.cell);
    if (std::isfinite(march_.distance(cell))) return cells * spec_.cell;
  }
  return 0.0;
}

}  // namespace bulletnav::bench
