// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "agent/mapping/goal_track.h"
#include "agent/mapping/map_navigator.h"
#include "agent/mapping/progress_watch.h"
#include "agent/models/goal_estimator.h"

namespace bulletnav::agent {

/// How a goal that has been seen is gone to. Metres, probabilities, steps.
struct ApproachSpec {
  int sightings = 2;             // of the goal that must agree
  double stop_distance = 0.5;    // to the goal, by F_R; episodes ask for less than 1
  double stop_certainty = 0.95;  // probability that it is the goal, to stop there
  int patience = 30;             // steps without coming nearer until it is given up
  double least_progress = 0.25;  // what counts as coming nearer
  double miss_within = 1.5;      // this near to it, in the open, it would be seen; 0: anything goes
  int misses = 3;                // steps in a row that it is not seen there until it is given up
};

/// What the configs of all agents that approach goals have; the rest as it is.
template <class Config>
ApproachSpec ApproachOf(const Config& config) {
  ApproachSpec spec;
  spec.sightings = config.sightings;
  spec.stop_distance = config.stop_distance;
  spec.stop_certainty = config.stop_certainty;
  return spec;
}

/// Walks to where the goal was seen and stops there, or finds out that it is not there, or that it
/// cannot be got to from here, as behind a counter: then it is set aside until more of the place is
/// known. The same for all agents that look for the goal with F_L and F_R; what they differ in is
/// how they explore.
/// Source: the stop and the local policy of Neural Topological SLAM, section 4.1; what happens when
/// a sighting was wrong is ours.
///   each step: approach.See(...); action = approach.Act(&navigator); absent: explore.
class GoalApproach {
 public:
  explicit GoalApproach(const ApproachSpec& spec);

  /// For a new goal.
  void Reset();

  /// What is seen of the goal in this step, with its probability; absent if nothing.
  void See(const std::optional<RelativeGoal>& goal, const MapNavigator& navigator);

  /// Absent if it is not known where the goal is, or it turned out not to be there. A stop that
  /// does not end the episode was in vain: the body goes nearer, and then looks elsewhere.
  std::optional<sim::Action> Act(MapNavigator* navigator);

  /// Where the goal is taken to be; absent if nowhere.
  std::optional<Point> target() const { return track_.point(); }

  /// Whether the goal may be at a point that somebody claims, having seen it from `distance` away
  /// with this probability. Not where it was looked for in vain.
  bool MayBeAt(const Point& point, double distance, double certainty) const {
    return !IsSetAside(point) && track_.IsNews(point, distance, certainty);
  }
  /// It was looked for at this point, in vain.
  void RefuteAt(const Point& point) { track_.RefuteAt(point); }
  /// For when there is nothing left to explore: the goal may be anywhere but where a stop was in
  /// vain.
  void Reconsider();

  /// Whether the goal would be seen from here if it were at `point`, `way` metres to walk from
  /// here, and has not been.
  bool Misses(const Point& point, double way, const MapNavigator& navigator);

 private:
  struct Attempt {
    bool was_stuck = false;      // on the way there
    bool has_forgotten = false;  // the map, for there was no way
    std::vector<Point> sides;    // where it was not found
    std::optional<Point> side;   // where it is looked for now
  };

  std::optional<sim::Action> Stop();
  std::optional<sim::Action> Refute();
  /// The goal seems to be where something stands, as on a counter, and it is not on this side.
  std::optional<sim::Action> TryOtherSide(const Point& target, MapNavigator* navigator);
  std::optional<sim::Action> SetAside(const Point& target, double seen);
  bool IsSetAside(const Point& point) const;
  bool IsNowhere(const std::optional<Waypoint>& plan, const MapNavigator& navigator) const;

  ApproachSpec spec_;
  GoalTrack track_;
  ProgressWatch watch_;
  std::optional<RelativeGoal> seen_;  // in this step
  int missed_ = 0;                    // steps in a row
  bool asked_ = false;                // in this step, whether it is missed
  bool stopped_ = false;              // in the last step
  bool was_vain_ = false;             // a stop at the present target
  Attempt attempt_;                   // at the present target
  double receded_ = 0.0;              // metres that the target has gone on before the body
  std::optional<Point> aside_;        // where the goal is that cannot be got to
  double seen_then_ = 0.0;            // m2
};

}  // namespace bulletnav::agent
