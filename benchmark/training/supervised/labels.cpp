// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/elementary.h"

namespace bulletnav::bench {

float PairLabel::near_score() const {
  return std::max(1.0f - distance_m() / static_cast<float>(agent::kNodeRadius), 0.0f);
}

sim::BodyPose PointAlong(const sim::BodyPose& from, int direction, double distance) {
  const double bearing = BearingOf(direction);
  return sim::Apply(from, {distance * sim::Cos(bearing), distance * sim::Sin(bearing), 0.0});
}

std::uint8_t QuantisedFarScore(double distance) {
  const double score = std::max(1.0 - distance / agent::kFarthestScored, 0.0);
  return static_cast<std::uint8_t>(std::lround(255.0 * score));
}

PairLabel LabelPose(const sim::PlanarPose& goal_in_source) {
  constexpr double kMost = std::numeric_limits<std::uint16_t>::max();
  const double millimetres = 1e3 * std::hypot(goal_in_source.x, goal_in_source.y);
  PairLabel label;
  label.direction =
      static_cast<std::uint8_t>(DirectionOf(sim::Atan2(goal_in_source.y, goal_in_source.x)));
  label.distance = static_cast<std::uint16_t>(std::lround(std::min(millimetres, kMost)));
  return label;
}

}  // namespace bulletnav::bench
