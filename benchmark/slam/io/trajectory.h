// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/slam/pose_graph/spatial_pose.h"

namespace bulletnav::bench {

/// Pose X_FC at a time (seconds) of a camera C with axes x right, y down, z ahead, in a file's
/// world F, whose z is up.
struct TimedPose {
  double time = 0.0;
  agent::SpatialPose pose;
};

/// Times rise.
using CameraTrajectory = std::vector<TimedPose>;

/// A pinhole camera, in pixels; the centre of the first pixel is 0, 0.
struct Intrinsics {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

}  // namespace bulletnav::bench
