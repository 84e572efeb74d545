// SPDX-License-Identifier: MIT
#include "benchmark/slam/recordings/visual_odometry.h"

#include <utility>

#include "benchmark/slam/io/file_frames.h"

namespace bulletnav::bench {

namespace {

// How far going there and back may end from where it began.
constexpr double kApart = 0.05;      // metres
constexpr double kTurned = 0.03;     // radians
constexpr double kShareOfWay = 0.1;  // of the motion, in addition

double AngleOf(const agent::SpatialPose& motion) {
  return agent::RotationVector(motion.rotation).norm();
}

}  // namespace

VisualOdometry::VisualOdometry(const Intrinsics& camera)
    : camera_(camera), pose_(CameraInFile(sim::PlanarPose{}, 0.0)) {}

agent::SpatialPose VisualOdometry::Next(const sim::Image& color, const DepthPicture& depth) {
  Frame frame;
  frame.features = agent::FindOrb(color.pixels, color.width, color.height, {});
  frame.depths = agent::DepthsAt(depth.metres, depth.width, depth.height, frame.features);
  if (last_) {
    ++steps_;
    const auto motion = Motion(*last_, frame);
    if (!motion) ++guessed_;
    step_ = motion.value_or(step_);
    pose_ = agent::Compose(pose_, step_);
  }
  last_ = std::move(frame);
  return pose_;
}

std::optional<agent::SpatialPose> VisualOdometry::Motion(const Frame& from, const Frame& to) const {
  const auto there = agent::FindMotion(from.corners(), to.corners(), camera_, {});
  const auto back = agent::FindMotion(to.corners(), from.corners(), camera_, {});
  if (!there || !back) return std::nullopt;
  // Each is by the depth of another frame.
  const agent::SpatialPose left = agent::Compose(there->X_AB, back->X_AB);
  const double apart = kApart + kShareOfWay * there->X_AB.position.norm();
  const double turned = kTurned + kShareOfWay * AngleOf(there->X_AB);
  if (left.position.norm() > apart || AngleOf(left) > turned) return std::nullopt;
  return there->X_AB;
}

}  // namespace bulletnav::bench
