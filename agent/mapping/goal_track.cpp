// SPDX-License-Identifier: MIT
#include "agent/mapping/goal_track.h"

#include <algorithm>

namespace bulletnav::agent {
namespace {

constexpr double kFading = 0.8;      // of older sightings' weight, a sighting
constexpr double kSameGoal = 1.5;    // metres between sightings of one place
constexpr double kVainRadius = 0.7;  // metres around a stop in vain
constexpr int kMostAstray = 3;       // then the mean was wrong
constexpr int kMostRefuted = 2;      // times that a place is gone to in vain
constexpr double kBeside = 0.5;      // metres
constexpr double kLeastRange = 0.3;  // metres; nearer sightings weigh no more

}  // namespace

void GoalTrack::Reset() {
  refuted_.clear();
  vain_.clear();
  Forget();
}

void GoalTrack::Refute() {
  if (agreeing_ > 0) refuted_.push_back(mean_);
  Forget();
}

void GoalTrack::RefuteAt(const Point& point) {
  refuted_.push_back(point);
  if (agreeing_ > 0 && Distance(point, mean_) < kSameGoal) Forget();
}

void GoalTrack::RefuteForGood() {
  if (agreeing_ > 0) vain_.push_back(mean_);
  Refute();
}

bool GoalTrack::IsNews(const Point& point, double distance, double certainty) const {
  const bool is_vain = std::any_of(vain_.begin(), vain_.end(), [&](const Point& wrong) {
    return Distance(point, wrong) < kVainRadius;
  });
  if (is_vain) return false;
  const auto times = std::count_if(refuted_.begin(), refuted_.end(), [&](const Point& wrong) {
    return Distance(point, wrong) < kSameGoal;
  });
  if (times == 0) return true;
  return certainty >= certainty_ && (times < kMostRefuted || distance <= kBeside);
}

void GoalTrack::Forget() {
  agreeing_ = 0;
  astray_ = 0;
  weight_ = 0.0;
}

bool GoalTrack::Add(const Point& point, double distance, double certainty) {
  if (!IsNews(point, distance, certainty)) return false;
  const double range = kLeastRange + distance;
  const double weight = 1.0 / (range * range);
  if (agreeing_ > 0 && Distance(point, mean_) > kSameGoal && ++astray_ < kMostAstray) return false;
  if (agreeing_ == 0 || astray_ >= kMostAstray) {
    Restart(point, weight);
    return true;
  }
  weight_ = kFading * weight_ + weight;
  mean_.x += (point.x - mean_.x) * weight / weight_;
  mean_.y += (point.y - mean_.y) * weight / weight_;
  astray_ = 0;
  ++agreeing_;
  return false;
}

std::optional<Point> GoalTrack::point() const {
  return agreeing_ >= needed_ ? std::optional(mean_) : std::nullopt;
}

void GoalTrack::Restart(const Point& point, double weight) {
  mean_ = point;
  weight_ = weight;
  agreeing_ = 1;
  astray_ = 0;
}

}  // namespace bulletnav::agent
