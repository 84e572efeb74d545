// SPDX-License-Identifier: MIT
#include "benchmark/play/metrics.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// d0 / max(d0, L): how much of the way was needed; 1 where none was and none was gone.
double Directness(const GoalRecord& record) {
  const double longer = std::max(record.start_distance, record.path_length);
  return longer > 0.0 ? record.start_distance / longer : 1.0;
}

/// max(0, 1 - d / d0): how much of the distance is gone.
double Progress(const GoalRecord& record) {
  if (record.start_distance > 0.0) {
    return std::max(0.0, 1.0 - record.distance_to_goal / record.start_distance);
  }
  return record.distance_to_goal > 0.0 ? 0.0 : 1.0;
}

}  // namespace

GoalMetrics Measure(const GoalRecord& record, const SuccessRule& rule) {
  CHECK(std::isfinite(record.start_distance) && record.start_distance >= 0.0);
  CHECK(record.path_length >= 0.0 && record.distance_to_goal >= 0.0);
  const bool counts = record.stopped || rule.no_stop;
  GoalMetrics metrics;
  metrics.success = counts && record.distance_to_goal < rule.distance;
  metrics.success_euclidean = counts && record.euclidean_distance < rule.distance;
  metrics.spl = metrics.success ? Directness(record) : 0.0;
  metrics.soft_spl = Progress(record) * Directness(record);
  metrics.start_distance = record.start_distance;
  metrics.distance_to_goal = record.distance_to_goal;
  metrics.euclidean_distance = record.euclidean_distance;
  metrics.path_length = record.path_length;
  metrics.steps = record.steps;
  metrics.collisions = record.collisions;
  return metrics;
}

GoalWatch::GoalWatch(const sim::NavmeshQuery& query, const Eigen::Vector3d& start,
                     const Eigen::Vector3d& goal, const SuccessRule& rule)
    : query_(query), position_(start), goal_(goal), rule_(rule) {
  record_.start_distance = Geodesic();
  if (!std::isfinite(record_.start_distance)) {
    throw sim::Error("no way leads from the start to the goal; check the episode and its scene");
  }
}

double GoalWatch::Geodesic() const {
  return query_.GeodesicDistance(position_.cast<float>(), goal_.cast<float>());
}

void GoalWatch::Step(const Eigen::Vector3d& position, bool collided) {
  record_.path_length += (position - position_).norm();
  record_.collisions += collided ? 1 : 0;
  ++record_.steps;
  position_ = position;
}

bool GoalWatch::Reached() const {
  // The floor under a point may lie a cell height off it: only what is clearly far needs no search.
  constexpr double kHeightError = 0.5;
  if ((goal_ - position_).norm() > rule_.distance + kHeightError) return false;
  return Geodesic() < rule_.distance;
}

GoalMetrics GoalWatch::Finish(bool stopped) const {
  GoalRecord record = record_;
  record.stopped = stopped;
  record.distance_to_goal = Geodesic();
  record.euclidean_distance = (goal_ - position_).norm();
  return Measure(record, rule_);
}

}  // namespace bulletnav::bench
