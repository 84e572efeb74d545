// SPDX-License-Identifier: MIT
#pragma once
#include "agent/slam/pose_graph/spatial_pose.h"
#include "benchmark/slam/io/text_lines.h"

namespace bulletnav::bench {

/// The pose whose numbers x y z qx qy qz qw begin at a word of a line. Quaternions of length 1 to
/// within a hundredth are normalised. Throws sim::FileError, naming the line.
agent::SpatialPose QuaternionPose(const TextLine& line, std::size_t first);

/// Throws sim::FileError, naming the line, for a place more than 10,000 km away: its squares would
/// soon be infinite, and no recording is of it.
void ExpectNear(const TextLine& line, const Eigen::Vector3d& position);

/// "x y z qx qy qz qw", with all digits and qw not negative.
std::string ToText(const agent::SpatialPose& pose);

}  // namespace bulletnav::bench
