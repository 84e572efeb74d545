// SPDX-License-Identifier: MIT
#include "agent/mapping/goal_approach.h"

#include <algorithm>
#include <utility>

namespace bulletnav::agent {
namespace {

constexpr int kGoal = 0;              // for the watch
constexpr double kSlack = 0.3;        // metres that a way may be longer than straight
constexpr double kNearEnough = 0.8;   // metres to stop in where one cannot come nearer
constexpr double kNowhereToGo = 0.1;  // metres to a waypoint
constexpr double kVainly = 0.2;       // metres to a goal that is not there
constexpr double kAsideRadius = 1.5;  // metres
constexpr double kAtSide = 0.3;       // metres
constexpr double kBeside = 0.2;       // metres to the end of a way that ends beside the target
constexpr double kOtherSide = 0.9;    // metres between two of these
constexpr int kMostSides = 3;
constexpr double kMostReceded = 12.0;  // metres that a goal told too near may go on before the body
constexpr double kSeenMore = 6.0;      // m2 until what was set aside is tried again

}  // namespace

GoalApproach::GoalApproach(const ApproachSpec& spec)
    : spec_(spec),
      track_(spec.sightings, spec.stop_certainty),
      watch_(spec.patience, spec.least_progress) {}

void GoalApproach::Reset() {
  track_.Reset();
  watch_.Reset();
  seen_.reset();
  missed_ = 0;
  asked_ = false;
  stopped_ = false;
  was_vain_ = false;
  attempt_ = {};
  receded_ = 0.0;
  aside_.reset();
}

void GoalApproach::Reconsider() {
  track_.Reconsider();
  aside_.reset();
}

void GoalApproach::See(const std::optional<RelativeGoal>& goal, const MapNavigator& navigator) {
  was_vain_ = was_vain_ || std::exchange(stopped_, false);
  seen_ = goal;
  if (navigator.seen_area() >= seen_then_ + kSeenMore) aside_.reset();
  if (!std::exchange(asked_, false) || goal) missed_ = 0;
  if (!goal) return;
  const std::optional<Point> before = track_.point();
  const bool is_elsewhere =
      track_.Add(navigator.PointAt(goal->distance, goal->bearing), goal->distance, goal->certainty);
  if (before && track_.point()) {
    const Point here = navigator.here();
    const double farther = Distance(*track_.point(), here) - Distance(*before, here);
    receded_ = std::clamp(receded_ + farther, 0.0, kMostReceded);
  }
  if (!is_elsewhere) return;
  watch_.Forget(kGoal);
  was_vain_ = false;
  attempt_ = {};
}

std::optional<sim::Action> GoalApproach::Act(MapNavigator* navigator) {
  const std::optional<Point> target = track_.point();
  if (!target) return std::nullopt;
  const double distance = Distance(*target, navigator->here());
  const bool is_certain = seen_ && seen_->certainty >= spec_.stop_certainty && !was_vain_;
  if (attempt_.side && Distance(*attempt_.side, navigator->here()) <= kAtSide && !is_certain) {
    return TryOtherSide(*target, navigator);
  }
  auto plan = navigator->Plan(attempt_.side.value_or(*target), true);
  // A sight of the goal across something that has to be gone round is no arrival.
  const bool is_open = plan && plan->distance <= distance + kSlack;
  if (is_certain && distance <= spec_.stop_distance && is_open) return Stop();
  if (distance <= (was_vain_ ? kVainly : kAtGoal) && !is_certain) return Refute();
  if (IsSetAside(*target)) return std::nullopt;
  const bool is_beside = plan && Distance(plan->point, navigator->here()) < kBeside &&
                         Distance(plan->point, *target) > kAtGoal;
  if (is_beside && !is_certain) {
    return TryOtherSide(*target, navigator);
  }
  if (IsNowhere(plan, *navigator) && !std::exchange(attempt_.has_forgotten, true)) {
    // Odometry may have smeared the map until it left no way.
    navigator->ForgetMap();
    plan = navigator->Plan(attempt_.side.value_or(*target), true);
  }
  if (IsNowhere(plan, *navigator)) {
    return is_certain && distance <= kNearEnough ? Stop() : Refute();
  }
  if (watch_.IsStuck(kGoal, plan->distance - receded_, navigator->seen_area())) {
    if (is_certain && distance <= kNearEnough) return Stop();
    if (attempt_.was_stuck && is_certain) return SetAside(*target, navigator->seen_area());
    navigator->ForgetMap();
    if (!is_certain) return Refute();
    attempt_.was_stuck = true;
  }
  if (Misses(*target, plan->distance, *navigator)) return Refute();
  return navigator->Steer(plan->point);
}

bool GoalApproach::Misses(const Point& point, double way, const MapNavigator& navigator) {
  asked_ = true;
  const double distance = Distance(point, navigator.here());
  const bool is_beside = distance <= spec_.miss_within && way <= distance + kSlack;
  missed_ = is_beside && !seen_ ? missed_ + 1 : 0;
  return missed_ >= spec_.misses;
}

bool GoalApproach::IsNowhere(const std::optional<Waypoint>& plan,
                             const MapNavigator& navigator) const {
  return !plan || Distance(plan->point, navigator.here()) < kNowhereToGo;
}

std::optional<sim::Action> GoalApproach::Stop() {
  stopped_ = true;
  return sim::Action::kStop;
}

std::optional<sim::Action> GoalApproach::Refute() {
  if (was_vain_) {
    track_.RefuteForGood();
  } else {
    track_.Refute();
  }
  watch_.Forget(kGoal);
  missed_ = 0;
  was_vain_ = false;
  attempt_ = {};
  receded_ = 0.0;
  return std::nullopt;
}

std::optional<sim::Action> GoalApproach::TryOtherSide(const Point& target,
                                                      MapNavigator* navigator) {
  attempt_.sides.push_back(navigator->here());
  attempt_.side.reset();
  if (static_cast<int>(attempt_.sides.size()) < kMostSides) {
    attempt_.side = navigator->PlaceNear(target, attempt_.sides, kOtherSide);
  }
  if (!attempt_.side) return Refute();
  const auto plan = navigator->Plan(*attempt_.side, true);
  if (IsNowhere(plan, *navigator)) return Refute();
  watch_.Forget(kGoal);
  return navigator->Steer(plan->point);
}

/// What is seen from everywhere around would be believed again at once if it were refuted.
std::optional<sim::Action> GoalApproach::SetAside(const Point& target, double seen) {
  aside_ = target;
  seen_then_ = seen;
  attempt_ = {};
  receded_ = 0.0;
  return std::nullopt;
}

bool GoalApproach::IsSetAside(const Point& point) const {
  return aside_ && Distance(*aside_, point) < kAsideRadius;
}

}  // namespace bulletnav::agent
