// SPDX-License-Identifier: MIT
#include "benchmark/play/metrics.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// What a goal adds to its episode's value.
std::optional<double> ShareOf(const GoalMetrics& goal, const Measure& measure) {
  const std::optional<double> value = goal.Find(measure.name);
  const bool stands = !value || std::isfinite(*value) || measure.if_infinite.empty();
  return stands ? value : goal.Find(measure.if_infinite);
}

}  // namespace

std::optional<double> GoalMetrics::Find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

double GoalMetrics::Value(std::string_view name) const {
  if (const auto value = Find(name)) return *value;
  throw sim::Error(fmt::format("these results have no '{}'; play the episodes again", name));
}

GoalMetrics MeasureGoal(const GoalRecord& record, const SuccessRule& rule) {
  BULLETNAV_CHECK(std::isfinite(record.start_distance) && record.start_distance >= 0.0);
  BULLETNAV_CHECK(record.path_length >= 0.0 && record.distance_to_goal >= 0.0);
  GoalMetrics metrics;
  for (const Measure& measure : AllMeasures()) {
    const double value = measure.value(record, rule);
    BULLETNAV_CHECK(!measure.is_main() || (value >= 0.0 && value <= 1.0));
    metrics[std::string(measure.name)] = value;
  }
  return metrics;
}

GoalMetrics UntriedGoal(const sim::NavmeshQuery& query, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& goal, double start_distance) {
  GoalRecord record;
  record.distance_to_goal = query.GeodesicDistance(from.cast<float>(), goal.cast<float>());
  record.start_distance =
      std::isfinite(record.distance_to_goal) ? record.distance_to_goal : start_distance;
  record.euclidean_distance = (goal - from).norm();
  record.failed = true;
  return MeasureGoal(record, {});
}

std::optional<double> EpisodeValue(const Measure& measure, std::span<const GoalMetrics> goals) {
  BULLETNAV_CHECK(!goals.empty());
  double sum = 0.0;
  int count = 0;
  for (const GoalMetrics& goal : goals) {
    if (measure.over_goals == OverGoals::kMeanOfReached && !goal.success()) continue;
    const std::optional<double> share = ShareOf(goal, measure);
    if (!share) return std::nullopt;
    sum += *share;
    ++count;
  }
  if (count == 0) return std::nullopt;
  // Divided after summing: ten goals of ten are 1.
  return measure.over_goals == OverGoals::kSum ? sum : sum / count;
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

GoalRecord GoalWatch::Record() const {
  GoalRecord record = record_;
  record.distance_to_goal = Geodesic();
  record.euclidean_distance = (goal_ - position_).norm();
  return record;
}

GoalMetrics GoalWatch::Finish(bool stopped) const {
  GoalRecord record = Record();
  record.stopped = stopped;
  return MeasureGoal(record, rule_);
}

GoalMetrics GoalWatch::Fail() const {
  GoalRecord record = Record();
  record.failed = true;
  return MeasureGoal(record, rule_);
}

}  // namespace bulletnav::bench
