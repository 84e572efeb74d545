// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include "benchmark/play/measure.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// What one goal of an episode came to: values of measures by name. Results of older runs lack
/// those that were not measured then.
class GoalMetrics {
 public:
  GoalMetrics() = default;
  GoalMetrics(std::initializer_list<std::pair<const std::string, double>> values)
      : values_(values) {}

  double& operator[](const std::string& name) { return values_[name]; }
  std::optional<double> Find(std::string_view name) const;
  /// Throws sim::Error if there is none.
  double Value(std::string_view name) const;

  bool success() const { return Value("success") != 0.0; }
  int Whole(std::string_view name) const { return static_cast<int>(Value(name)); }
  bool operator==(const GoalMetrics&) const = default;

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// All measures of a finished goal.
GoalMetrics MeasureGoal(const GoalRecord& record, const SuccessRule& rule);

/// Those of a goal that an agent, taken off at `from` or before, never set out for. Where no way
/// leads there, `start_distance` stands for its length.
GoalMetrics UntriedGoal(const sim::NavmeshQuery& query, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& goal, double start_distance);

/// What an episode counts with in one measure; empty if a goal lacks it, or none counts. Expects:
/// at least one goal (checked).
std::optional<double> EpisodeValue(const Measure& measure, std::span<const GoalMetrics> goals);

/// Watches a body on its way to one goal. Give it every true position, the first included; under
/// `no_stop` the goal is over as soon as Reached() says so.
class GoalWatch {
 public:
  /// The query must outlive the watch. Throws sim::Error if no way leads from start to goal.
  GoalWatch(const sim::NavmeshQuery& query, const Eigen::Vector3d& start,
            const Eigen::Vector3d& goal, const SuccessRule& rule);

  /// One step further: where the body is now and whether it met something.
  void Step(const Eigen::Vector3d& position, bool collided);
  /// Whether the body is near the goal now. Cost: one geodesic if the straight line is short.
  bool Reached() const;
  /// Metres of way left from where the body now is.
  double Geodesic() const;
  /// The facts so far.
  GoalRecord Record() const;
  GoalMetrics Finish(bool stopped) const;
  /// Of an agent that was taken off on its way.
  GoalMetrics Fail() const;

 private:
  const sim::NavmeshQuery& query_;
  Eigen::Vector3d position_;
  Eigen::Vector3d goal_;
  SuccessRule rule_;
  GoalRecord record_;
};

}  // namespace bulletnav::bench
