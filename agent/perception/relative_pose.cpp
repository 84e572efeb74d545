// SPDX-License-Identifier: MIT
#include "agent/perception/relative_pose.h"

#include <algorithm>
#include <cmath>

#include "sim/math/pose.h"

namespace bulletnav::agent {
namespace {

constexpr double kWidth = 2.0 * sim::kPi / kDirections;

}  // namespace

double BearingOf(int direction) {
  return sim::WrapAngle(kWidth * direction);
}

int DirectionOf(double bearing) {
  const auto turns = std::lround(sim::WrapAngle(bearing) / kWidth);
  return static_cast<int>((turns + kDirections) % kDirections);
}

RelativeGoal RelativePoseOf(const PairPrediction& prediction) {
  const auto& p = prediction.direction;
  const auto best = std::distance(p.begin(), std::max_element(p.begin(), p.end()));
  const auto peak = static_cast<std::size_t>(best);
  const double left = p[(peak + 1) % kDirections];
  const double right = p[(peak + kDirections - 1) % kDirections];
  const double sum = left + right + p[peak];
  const double shift = sum > 0.0 ? kWidth * (left - right) / sum : 0.0;
  return {prediction.distance, sim::WrapAngle(BearingOf(static_cast<int>(peak)) + shift),
          prediction.same_node};
}

}  // namespace bulletnav::agent
