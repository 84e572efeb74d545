// SPDX-License-Identifier: MIT
#include "agent/slam/loops/odometry_prior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kStep = 0.01;                  // metres
constexpr double kTurn = sim::DegToRad(0.3);    // radians a step
constexpr double kShared = sim::DegToRad(0.1);  // radians a step, the same in all
constexpr double kSoft = 1.0;                   // square metres
constexpr double kMost = 2.0;                   // more than any two scores differ by

}  // namespace

void OdometryPriorSpec::Validate() const {
  if (!(odometry_weight >= 0.0 && odometry_reach_m >= 0.0)) {
    throw sim::Error("odometry_weight and odometry_reach_m must not be negative");
  }
}

void OdometryTrack::Add(const sim::PlanarPose& pose) {
  const Eigen::Vector2d place(pose.x, pose.y);
  const bool is_first = places_.empty();
  sums_.push_back(is_first ? place : Eigen::Vector2d(sums_.back() + place));
  squares_.push_back((is_first ? 0.0 : squares_.back()) + place.squaredNorm());
  places_.push_back(place);
}

double OdometryTrack::Apart(int later, int earlier) const {
  return (places_[static_cast<std::size_t>(later)] - places_[static_cast<std::size_t>(earlier)])
      .norm();
}

double OdometryTrack::Variance(int later, int earlier) const {
  const auto last = static_cast<std::size_t>(later);
  const auto first = static_cast<std::size_t>(earlier);
  const double steps = later - earlier;
  const Eigen::Vector2d& end = places_[last];
  // A turn at a step moves the end by its distance from there; the sums are over all steps.
  const Eigen::Vector2d sum = sums_[last] - sums_[first];
  const double squares = squares_[last] - squares_[first];
  const double arms = steps * end.squaredNorm() - 2.0 * end.dot(sum) + squares;
  const double together = (steps * end - sum).squaredNorm();
  return 2.0 * steps * kStep * kStep + kTurn * kTurn * std::max(arms, 0.0) +
         kShared * kShared * together;
}

double OdometryTrack::Against(int later, int earlier, const OdometryPriorSpec& spec) const {
  if (spec.odometry_weight == 0.0) return 0.0;
  const double beyond = Apart(later, earlier) - spec.odometry_reach_m;
  if (beyond <= 0.0) return 0.0;
  const double squared = beyond * beyond / (Variance(later, earlier) + kSoft);
  return std::min(spec.odometry_weight * squared, kMost);
}

}  // namespace bulletnav::agent
