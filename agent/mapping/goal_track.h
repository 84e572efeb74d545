// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "agent/mapping/metric_map.h"

namespace bulletnav::agent {

/// Where the goal is in the agent's plane, from sightings by F_R that each err: a mean in which
/// near sightings weigh more, for their bearing errs by less, and old ones less.
class GoalTrack {
 public:
  /// `sightings`: that must agree before the goal is taken to be somewhere.
  explicit GoalTrack(int sightings) : needed_(sightings) {}

  void Reset();
  /// `distance`: by F_R, metres. Sightings far from the mean are left out, unless they go on.
  void Add(const Point& point, double distance);

  /// Absent if it has not been seen often enough.
  std::optional<Point> point() const;

 private:
  void Restart(const Point& point, double weight);

  int needed_;
  int agreeing_ = 0;
  int astray_ = 0;  // sightings in a row that were left out
  double weight_ = 0.0;
  Point mean_;
};

}  // namespace bulletnav::agent
