// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "agent/mapping/metric_map.h"

namespace bulletnav::agent {

/// Metres from a goal from where an agent would be quite certain of it, if it were there.
inline constexpr double kAtGoal = 0.3;

/// Where the goal is in the agent's plane, from sightings by F_R that each err: a mean in which
/// near sightings weigh more, for their bearing errs by less, and old ones less.
class GoalTrack {
 public:
  /// `sightings`: that must agree before the goal is taken to be somewhere. `certainty`: the
  /// probability from which a sighting is believed whatever was refuted.
  GoalTrack(int sightings, double certainty) : needed_(sightings), certainty_(certainty) {}

  void Reset();
  /// `distance`: by F_R, metres; `certainty`: its probability. Sightings far from the mean are left
  /// out, unless they go on. Returns whether the goal is taken to be elsewhere than before.
  bool Add(const Point& point, double distance, double certainty);

  /// The goal turned out not to be at point(): less certain sightings of it there are no news, and
  /// after a second time only such from beside it are.
  void Refute();
  /// The same of any point; what is known of the goal elsewhere stays.
  void RefuteAt(const Point& point);
  /// The body has stopped at point() and it was not the goal: nothing is news there.
  void RefuteForGood();
  /// What was refuted, but not for good, counts as news again.
  void Reconsider() { refuted_.clear(); }

  /// Whether a sighting would be believed.
  bool IsNews(const Point& point, double distance, double certainty) const;

  /// Absent if it has not been seen often enough.
  std::optional<Point> point() const;

 private:
  void Forget();
  void Restart(const Point& point, double weight);

  int needed_;
  double certainty_;
  std::vector<Point> refuted_;
  std::vector<Point> vain_;  // refuted for good
  int agreeing_ = 0;
  int astray_ = 0;  // sightings in a row that were left out
  double weight_ = 0.0;
  Point mean_;
};

}  // namespace bulletnav::agent
