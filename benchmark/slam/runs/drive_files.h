// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/slam/runs/drive_play.h"

namespace bulletnav::bench {

/// Writes a drive into its folder, and the folder is whole once result.yaml is there, which comes
/// last: groundtruth.tum (where it is known), odometry.tum; of each detector NAME.tum, the
/// optimised trajectory, NAME.g2o, its pose graph, NAME.csv, the pairs that it took for loops,
/// NAME.similarity.png and, where it has some, NAME.sequences.yaml, see drive_traces.h;
/// covisible.png and times.yaml. Cameras at height 0, at the times of their frames: a recording's
/// own, or ten a second. Throws sim::FileError.
void WriteDrive(const std::filesystem::path& folder, const PlayedDrive& drive);

bool HasDrive(const std::filesystem::path& folder);
/// Throws sim::FileError.
DriveResult ReadDriveResult(const std::filesystem::path& folder);
/// Empty where there are none, as in results that were kept without. Throws sim::FileError.
TimesByStage ReadDriveTimes(const std::filesystem::path& folder);

/// What WriteDrive wrote of a drive: the true poses (none where they are not known), the poses that
/// NAME, a detector or "odometry", has, from the first frame's body, and the pairs that a detector
/// took for loops. All throw sim::FileError.
std::vector<sim::BodyPose> ReadTruth(const std::filesystem::path& folder);
std::vector<sim::PlanarPose> ReadPoses(const std::filesystem::path& folder,
                                       const std::string& name);
std::vector<LoopRecord> ReadLoops(const std::filesystem::path& folder, const std::string& detector);

}  // namespace bulletnav::bench
