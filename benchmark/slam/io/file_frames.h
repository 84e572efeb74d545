// SPDX-License-Identifier: MIT
// Here alone the simulator's frames become those of files and back.
#pragma once
#include "agent/slam/pose_graph/spatial_pose.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// Frames: the simulator's world W has x right, y up, z back, and yaw 0 looks along -z. A file's
/// world F has x along W's -z, y along W's -x, z up: yaw 0 looks along x, and yaws are the same.
/// A camera C has x right, y down, z ahead.

/// X_FC of an upright body's camera, `camera_height` metres over its floor.
agent::SpatialPose CameraInFile(const sim::BodyPose& X_WB, double camera_height);

/// The upright body whose camera is at X_FC: what pitch and roll the camera has is left out.
/// Throws sim::Error if it looks straight up or down, where there is no yaw.
sim::BodyPose BodyFromFile(const agent::SpatialPose& X_FC, double camera_height);

/// What BodyFromFile leaves out of a camera's rotation: from its own axes ahead, left, up to those
/// of the upright body. Throws sim::Error as above.
Eigen::Matrix3d LevelFromCamera(const agent::SpatialPose& X_FC);

/// X_FC of a body's camera that moves in a plane, x ahead and y to the left of where it began.
agent::SpatialPose CameraInFile(const sim::PlanarPose& X_FB, double camera_height);

/// As CameraInFile's second; height, pitch and roll are left out. Throws sim::Error as above.
sim::PlanarPose PlanarFromFile(const agent::SpatialPose& X_FC);

}  // namespace bulletnav::bench
