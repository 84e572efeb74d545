// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/privileged/oracle_goal_estimator.h"

#include <cmath>

#include <Eigen/Geometry>

namespace bulletnav::bench {
namespace {

constexpr double kReach = 3.0;  // metres: the radius of a node
constexpr double kHalfPatch = sim::DegToRad(2.5);
constexpr int kRays = 5;

}  // namespace

std::optional<agent::RelativeGoal> OracleGoalEstimator::Estimate(const agent::Panorama& /*here*/,
                                                                 const agent::Panorama& /*goal*/) {
  const sim::PlanarPose goal = sim::RelativePose(truth_.pose, truth_.goal);
  if ((truth_.goal.position - truth_.pose.position).norm() > kReach || !IsVisible()) {
    return std::nullopt;
  }
  return agent::RelativeGoal{std::hypot(goal.x, goal.y), std::atan2(goal.y, goal.x)};
}

bool OracleGoalEstimator::IsVisible() const {
  const Eigen::Vector3d up(0, truth_.body.camera_height, 0);
  const Eigen::Vector3d eye = truth_.pose.position + up;
  const Eigen::Vector3d to_goal = truth_.goal.position + up - eye;
  for (int i = 0; i < kRays; ++i) {
    const double angle = kHalfPatch * (2.0 * i / (kRays - 1) - 1.0);
    const Eigen::Vector3d ray = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) * to_goal;
    const Eigen::Vector3d end = eye + ray;
    if (!truth_.world->physics().RayTest(eye.cast<float>(), end.cast<float>())) return true;
  }
  return false;
}

}  // namespace bulletnav::bench
