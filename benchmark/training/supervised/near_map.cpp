// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/near_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "agent/models/semantic_model.h"
#include "benchmark/training/supervised/labels.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using sim::Cell;
using sim::CellState;

constexpr double kLongestWay = 1.05 * agent::kNodeRadius;
/// Metres; about as far as a way of 1.05 r can stray from the straight line, r sqrt(1.05^2 - 1)
/// / 2.
constexpr double kHiddenReach = 0.5;
constexpr double kMarchError = 0.05;     // share by which a march's ways may be too long
constexpr double kRoundingSlack = 0.01;  // cells: a radius in single precision is no whole number

}  // namespace

NearMap::NearMap(const DataConfig& config)
    : ring_({config.panorama, false, true, config.body.camera_height}, spec_),
      body_(static_cast<int>(std::ceil(double{config.body.radius} / spec_.cell - kRoundingSlack))),
      slack_(static_cast<int>(std::lround(config.target_slack / spec_.cell))),
      hidden_(config.hidden == HiddenFloor::kFree ? sim::CellState::kUnknown
                                                  : sim::CellState::kBlocked),
      middle_{ring_.reach(), ring_.reach()},
      states_(2 * ring_.reach() + 1),
      seen_ways_(states_.size()),
      ways_(states_.size()) {}

void NearMap::Project(std::span<const float> depth) {
  ring_.Project({{}, depth}, 0.5, 0.5, 0.0);
  states_.Fill(sim::CellState::kBlocked);
  const int last = states_.size() - 1;
  for (int y = 1; y < last; ++y) {
    for (int x = 1; x < last; ++x) {
      states_[{x, y}] = ring_.seen()[{x, y}] != 0 ? sim::CellState::kFree : hidden_;
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
  seen_ways_.Run(states_, {.from = middle_});
  ways_.Run(states_, {.from = middle_, .through_unknown = true});
}

void NearMap::BlockAround(const sim::Cell& obstacle) {
  for (int dy = -body_; dy <= body_; ++dy) {
    for (int dx = -body_; dx <= body_; ++dx) {
      const sim::Cell cell{obstacle.x + dx, obstacle.y + dy};
      if (dx * dx + dy * dy > body_ * body_ || !states_.Contains(cell)) continue;
      states_[cell] = sim::CellState::kBlocked;
    }
  }
}

/// Growing obstacles by whole cells must not wall in a body that stands close to them.
void NearMap::FreeMiddle() {
  for (int dy = -body_; dy <= body_; ++dy) {
    for (int dx = -body_; dx <= body_; ++dx) {
      if (dx * dx + dy * dy > body_ * body_) continue;
      states_[{middle_.x + dx, middle_.y + dy}] = sim::CellState::kFree;
    }
  }
}

sim::Cell NearMap::CellAlong(int direction, double distance) const {
  const double bearing = BearingOf(direction);
  const double cells = distance / spec_.cell;
  return {middle_.x + static_cast<int>(std::lround(cells * sim::Cos(bearing))),
          middle_.y + static_cast<int>(std::lround(cells * sim::Sin(bearing)))};
}

bool NearMap::IsExplorable(int direction) const {
  return WayTo(direction) < kLongestWay;
}

double NearMap::WayTo(int direction) const {
  const sim::Cell target = CellAlong(direction, agent::kNodeRadius);
  double least = std::numeric_limits<double>::infinity();
  if (!IsNearSeenFloor(target)) return least;
  for (int dy = -slack_; dy <= slack_; ++dy) {
    for (int dx = -slack_; dx <= slack_; ++dx) {
      const sim::Cell cell{target.x + dx, target.y + dy};
      const double gap = Distance(cell, target);
      if (gap <= slack_ && states_.Contains(cell)) least = std::min(least, CellsTo(cell) + gap);
    }
  }
  return least * spec_.cell;
}

bool NearMap::IsNearSeenFloor(const sim::Cell& cell) const {
  const int reach = static_cast<int>(std::lround(kHiddenReach / spec_.cell));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell other{cell.x + dx, cell.y + dy};
      if (dx * dx + dy * dy > reach * reach || !states_.Contains(other)) continue;
      if (std::isfinite(seen_ways_.distance(other))) return true;
    }
  }
  return false;
}

/// Length of the way to a cell, in cells.
double NearMap::CellsTo(const sim::Cell& cell) const {
  if (states_[cell] == sim::CellState::kBlocked) return std::numeric_limits<double>::infinity();
  if (LineCost(states_, middle_, cell)) return Distance(middle_, cell);
  const double marched = double{ways_.distance(cell)};
  const double longest = kLongestWay / spec_.cell;
  if (marched < longest || marched > (1.0 + kMarchError) * longest) return marched;
  return std::min(marched, WithOneBend(cell, longest));
}

/// Length in cells of the shortest way of two straight parts; infinite if longer than `longest`.
double NearMap::WithOneBend(const sim::Cell& cell, double longest) const {
  double least = longest;
  for (int y = 0; y < states_.size(); ++y) {
    for (int x = 0; x < states_.size(); ++x) {
      const double length = Distance({x, y}, middle_) + Distance({x, y}, cell);
      if (length >= least || states_[{x, y}] == sim::CellState::kBlocked) continue;
      if (LineCost(states_, middle_, {x, y}) && LineCost(states_, {x, y}, cell)) least = length;
    }
  }
  return least < longest ? least : std::numeric_limits<double>::infinity();
}

double NearMap::Reach(int direction) const {
  for (auto cells = std::lround(agent::kNodeRadius / spec_.cell); cells > 0; --cells) {
    const double reach = static_cast<double>(cells) * spec_.cell;
    if (std::isfinite(seen_ways_.distance(CellAlong(direction, reach)))) return reach;
  }
  return 0.0;
}

}  // namespace bulletnav::bench
