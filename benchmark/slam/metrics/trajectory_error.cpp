// SPDX-License-Identifier: MIT
#include "benchmark/slam/metrics/trajectory_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using Poses = std::span<const sim::PlanarPose>;

bool IsFinite(const sim::PlanarPose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

void Check(Poses truth, Poses estimate) {
  if (truth.size() != estimate.size() || truth.empty()) {
    throw sim::Error(
        fmt::format("{} poses cannot be held against {} true ones; give one for each, at least one",
                    estimate.size(), truth.size()));
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (IsFinite(truth[i]) && IsFinite(estimate[i])) continue;
    throw sim::Error(fmt::format("pose {} of a trajectory is not finite; leave it out", i + 1));
  }
}

Eigen::Vector2d MeanPoint(Poses poses) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (const sim::PlanarPose& pose : poses) sum += Eigen::Vector2d(pose.x, pose.y);
  return sum / static_cast<double>(poses.size());
}

/// The turn that is best about the middles has the tangent of sums of products.
sim::PlanarPose PlanarAlignment(Poses truth, Poses estimate) {
  const Eigen::Vector2d middle = MeanPoint(truth);
  const Eigen::Vector2d from = MeanPoint(estimate);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector2d t = Eigen::Vector2d(truth[i].x, truth[i].y) - middle;
    const Eigen::Vector2d e = Eigen::Vector2d(estimate[i].x, estimate[i].y) - from;
    along += e.dot(t);
    across += e.x() * t.y() - e.y() * t.x();
  }
  const double yaw = std::atan2(across, along);
  const sim::PlanarPose turned = sim::Compose({0.0, 0.0, yaw}, {from.x(), from.y(), 0.0});
  return {middle.x() - turned.x, middle.y() - turned.y, yaw};
}

}  // namespace

sim::PlanarPose AlignmentOf(Poses truth, Poses estimate, Alignment alignment) {
  Check(truth, estimate);
  switch (alignment) {
    case Alignment::kStart:
      return Compose(truth.front(), Inverse(estimate.front()));
    case Alignment::kPlanar:
      return PlanarAlignment(truth, estimate);
  }
  return {};
}

std::vector<double> PoseErrors(Poses truth, Poses estimate, Alignment alignment) {
  const sim::PlanarPose over = AlignmentOf(truth, estimate, alignment);
  std::vector<double> errors;
  errors.reserve(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const sim::PlanarPose laid = Compose(over, estimate[i]);
    errors.push_back(std::hypot(laid.x - truth[i].x, laid.y - truth[i].y));
  }
  return errors;
}

TrajectoryError MeasureTrajectory(Poses truth, Poses estimate, Alignment alignment) {
  const std::vector<double> errors = PoseErrors(truth, estimate, alignment);
  const auto count = static_cast<double>(errors.size());
  const auto [min, max] = std::minmax_element(errors.begin(), errors.end());
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  return {*min, sum / count, *max, std::sqrt(squares / count)};
}

}  // namespace bulletnav::bench
