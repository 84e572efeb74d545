// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/privileged/shortest_path.h"

#include <cmath>
#include <cstdlib>

#include "sim/base/error.h"
#include "sim/noise/noise_model.h"

namespace bulletnav::bench {
namespace {

using sim::Action;

constexpr double kOnCorner = 0.05;   // metres; such a corner counts as passed
constexpr double kLeastGain = 0.08;  // metres; less is being stuck

double Step() {
  return sim::NominalMotion(Action::kMoveForward).x;
}
double Turn() {
  return sim::NominalMotion(Action::kTurnLeft).yaw;
}

/// Heading of a level direction as a BodyPose's yaw.
double Heading(const Eigen::Vector3d& direction) {
  return std::atan2(-direction.x(), -direction.z());
}

double Level(const Eigen::Vector3d& v) {
  return std::hypot(v.x(), v.z());
}

/// The action that brings the body nearer to a heading; absent if no turn does.
std::optional<Action> TurnTo(double heading, const sim::BodyPose& pose) {
  const double off = sim::WrapAngle(heading - pose.yaw);
  if (std::fabs(off) <= 0.5 * Turn() + 1e-6) return std::nullopt;
  return off > 0.0 ? Action::kTurnLeft : Action::kTurnRight;
}

}  // namespace

void ShortestPathAgent::Config::Validate() const {
  if (!(stop_distance > 0.0)) throw sim::Error("stop_distance must be positive");
}

void ShortestPathAgent::Reset(const GroundTruth& truth) {
  if (world_ != truth.world) {
    world_ = truth.world;
    query_.emplace(world_->navmesh());
  }
  way_out_.reset();
}

Action ShortestPathAgent::Act(const GroundTruth& truth) {
  const Eigen::Vector3f here = truth.pose.position.cast<float>();
  const auto path = query_->FindPath(here, truth.goal.position.cast<float>());
  if (!path || path->length < config_.stop_distance) return Action::kStop;
  if (way_out_) {
    if (const auto turn = TurnTo(*way_out_, truth.pose)) return *turn;
    way_out_.reset();
    return Action::kMoveForward;
  }
  for (const Eigen::Vector3f& corner : path->points) {
    const Eigen::Vector3d to_corner = corner.cast<double>() - truth.pose.position;
    if (Level(to_corner) < kOnCorner) continue;
    if (const auto turn = TurnTo(Heading(to_corner), truth.pose)) return *turn;
    break;
  }
  if (Gain(truth, 0, path->length) >= kLeastGain) return Action::kMoveForward;
  const int turns = BestTurns(truth, path->length);
  if (turns == 0) return Action::kMoveForward;
  way_out_ = truth.pose.yaw + turns * Turn();
  return turns > 0 ? Action::kTurnLeft : Action::kTurnRight;
}

double ShortestPathAgent::DistanceLeft(const sim::BodyPose& pose, const GroundTruth& truth) const {
  return query_->GeodesicDistance(pose.position.cast<float>(), truth.goal.position.cast<float>());
}

double ShortestPathAgent::Gain(const GroundTruth& truth, int turns, double left) const {
  sim::CapsuleBody body(truth.world->physics(), truth.body);
  try {
    body.Reset(truth.pose);
  } catch (const sim::PoseError&) {
    return 0.0;  // wedged in so that physics would not put it there anew
  }
  body.Move({0.0, 0.0, turns * Turn()});
  body.Move({Step(), 0.0, 0.0});
  return left - DistanceLeft(body.pose(), truth);
}

/// The fewest turns among the headings that gain the most.
int ShortestPathAgent::BestTurns(const GroundTruth& truth, double left) const {
  constexpr double kTie = 0.01;
  const int half = static_cast<int>(std::lround(sim::kPi / Turn()));
  int best = 0;
  double best_gain = -1e9;
  for (int k = 0; k <= 2 * half; ++k) {
    const int turns = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    const double gain = Gain(truth, turns, left);
    if (gain < best_gain + kTie) continue;
    best_gain = gain;
    best = turns;
  }
  return best;
}

}  // namespace bulletnav::bench
