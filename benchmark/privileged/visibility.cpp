// SPDX-License-Identifier: MIT
#include "benchmark/privileged/visibility.h"

#include <Eigen/Geometry>

#include "agent/models/semantic_model.h"
#include "sim/math/rotation.h"

namespace bulletnav::bench {
namespace {

constexpr double kHalfPatch = sim::DegToRad(2.5);
constexpr int kRays = 5;

}  // namespace

bool IsInNode(const sim::World& world, const sim::BodySpec& body, const sim::BodyPose& source,
              const sim::BodyPose& goal) {
  if ((goal.position - source.position).norm() > agent::kNodeRadius) return false;
  const Eigen::Vector3d up(0, body.camera_height, 0);
  const Eigen::Vector3d eye = source.position + up;
  const Eigen::Vector3d to_goal = goal.position + up - eye;
  for (int i = 0; i < kRays; ++i) {
    const double angle = kHalfPatch * (2.0 * i / (kRays - 1) - 1.0);
    const Eigen::Vector3d ray =
        sim::RotationAbout<double>(Eigen::Vector3d::UnitY(), angle) * to_goal;
    const Eigen::Vector3d end = eye + ray;
    if (!world.physics().RayTest(eye.cast<float>(), end.cast<float>())) return true;
  }
  return false;
}

}  // namespace bulletnav::bench
