// SPDX-License-Identifier: MIT
#include "benchmark/privileged/shortest_path.h"

#include <cmath>

#include "benchmark/privileged/way_out.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {
namespace {

using sim::Action;

constexpr double kPassed = 0.05;      // metres; a corner this near is behind
constexpr double kPassedStep = 0.13;  // the same for the way out: half a step
constexpr double kLeastGain = 0.08;   // metres; less is being stuck
constexpr int kPatience = 6;          // actions for each step of the way out

double Level(const Eigen::Vector3d& v) {
  return std::hypot(v.x(), v.z());
}

Eigen::Vector3d NextCorner(const sim::Path& path, const sim::BodyPose& pose) {
  for (const Eigen::Vector3f& corner : path.points) {
    if (Level(corner.cast<double>() - pose.position) >= kPassed) return corner.cast<double>();
  }
  return path.points.back().cast<double>();
}

}  // namespace

void ShortestPathAgent::Config::Validate() const {
  if (!(stop_distance > 0.0)) throw sim::Error("stop_distance must be positive");
  if (!(turn_tolerance_deg >= 5.0) || !(turn_tolerance_deg <= 45.0)) {
    throw sim::Error("turn_tolerance_deg must lie between 5, half a turn, and 45");
  }
}

void ShortestPathAgent::Reset(const GroundTruth& truth) {
  if (world_ != truth.world) {
    query_.reset();
    world_ = truth.world;
    query_.emplace(world_->navmesh());
  }
  way_out_.clear();
  pause_ = 0;
}

Action ShortestPathAgent::Act(const GroundTruth& truth) {
  return Advise(truth).action;
}

ShortestPathAgent::Advice ShortestPathAgent::Advise(const GroundTruth& truth) {
  const auto path =
      query_->FindPath(truth.pose.position.cast<float>(), truth.goal.position.cast<float>());
  if (!path) return {Action::kStop, false};
  if (path->length < config_.stop_distance) return {Action::kStop, true};
  if (const auto action = FollowWayOut(truth.pose)) return {*action, true};
  const Action action = Towards(NextCorner(*path, truth.pose), truth.pose);
  if (pause_ > 0) --pause_;
  if (action != Action::kMoveForward || GainAhead(truth, path->length) >= kLeastGain) {
    return {action, true};
  }
  if (pause_ > 0) return {action, false};
  const auto way = FindWayOut(truth, *query_);
  if (way.empty()) pause_ = config_.search_pause;
  way_out_.assign(way.begin(), way.end());
  patience_ = kPatience * static_cast<int>(way.size()) + 18;
  if (const auto out = FollowWayOut(truth.pose)) return {*out, true};
  return {action, false};
}

Action ShortestPathAgent::Towards(const Eigen::Vector3d& point, const sim::BodyPose& pose) const {
  const Eigen::Vector3d way = point - pose.position;
  const double off = sim::WrapAngle(sim::Atan2(-way.x(), -way.z()) - pose.yaw);
  if (std::fabs(off) <= sim::DegToRad(config_.turn_tolerance_deg) + 1e-6) {
    return Action::kMoveForward;
  }
  return off > 0.0 ? Action::kTurnLeft : Action::kTurnRight;
}

std::optional<Action> ShortestPathAgent::FollowWayOut(const sim::BodyPose& pose) {
  while (!way_out_.empty() && Level(way_out_.front() - pose.position) < kPassedStep) {
    way_out_.pop_front();
  }
  if (way_out_.empty()) return std::nullopt;
  if (--patience_ < 0 || Level(way_out_.front() - pose.position) > config_.most_stray) {
    way_out_.clear();
    return std::nullopt;
  }
  return Towards(way_out_.front(), pose);
}

double ShortestPathAgent::GainAhead(const GroundTruth& truth, double left) const {
  sim::CapsuleBody body(truth.world->physics(), truth.body);
  // Where physics would not put it anew, it cannot be asked.
  if (!body.TryReset(truth.pose)) return left;
  body.Move({sim::NominalMotion(Action::kMoveForward).x, 0.0, 0.0});
  return left - query_->GeodesicDistance(body.pose().position.cast<float>(),
                                         truth.goal.position.cast<float>());
}

namespace {

const PrivilegedRegistration<ShortestPathAgent> registration;

}  // namespace

}  // namespace bulletnav::bench
