// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/slam/io/trajectory.h"

namespace bulletnav::bench {

/// Poses of KITTI's odometry benchmark: a line each, the first three rows of a 4 x 4 matrix, row by
/// row, of the camera as the first camera sees it. What is returned has the first camera at the
/// origin of a file's world, looking along x.
/// Throws sim::FileError with the line: not 12 finite numbers, no rotation.
/// Source: Geiger et al., "Are we ready for autonomous driving?", CVPR 2012.
std::vector<agent::SpatialPose> ReadKittiPoses(const std::filesystem::path& file);

/// The same of any trajectory, seen from its first camera.
std::string ToKitti(const CameraTrajectory& trajectory);

/// times.txt: a line each, seconds. Throws sim::FileError with the line: times that do not rise.
std::vector<double> ReadKittiTimes(const std::filesystem::path& file);
std::string ToKittiTimes(const CameraTrajectory& trajectory);

/// calib.txt: lines "P0: " to "P3: " and 12 numbers, a camera's 3 x 4 projection. Throws
/// sim::FileError if the camera is not there, so that its intrinsics are unknown, or focal lengths
/// are not positive.
Intrinsics ReadKittiCalibration(const std::filesystem::path& file, int camera);
/// How far camera `right` is to the right of camera `left`, metres. Throws sim::FileError likewise,
/// and if it is not to its right.
double ReadKittiBaseline(const std::filesystem::path& file, int left, int right);
/// All four cameras alike.
std::string ToKittiCalibration(const Intrinsics& intrinsics);

/// Poses and times together. Throws sim::FileError as above, and if there are not as many of one
/// as of the other.
CameraTrajectory ReadKittiTrajectory(const std::filesystem::path& poses,
                                     const std::filesystem::path& times);

}  // namespace bulletnav::bench
