// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/slam/pose_graph/spatial_pose.h"
#include "agent/slam/verify/pinhole.h"

namespace bulletnav::bench {

/// Pose X_FC at a time (seconds) of a camera C with axes x right, y down, z ahead, in a file's
/// world F, whose z is up.
struct TimedPose {
  double time = 0.0;
  agent::SpatialPose pose;
};

/// Times rise.
using CameraTrajectory = std::vector<TimedPose>;

/// What files call the numbers of a camera.
using Intrinsics = agent::Pinhole;

/// Frames of a drive that have no times of their own.
inline constexpr double kFramesASecond = 10.0;

}  // namespace bulletnav::bench
