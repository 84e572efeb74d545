// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "benchmark/slam/runs/drive_play.h"

namespace bulletnav::bench {

/// Writes a drive into its folder, and the folder is whole once result.yaml is there, which comes
/// last: groundtruth.tum (where it is known), odometry.tum; of each detector NAME.tum, the
/// optimised trajectory, NAME.g2o, its pose graph, and NAME.csv, the pairs that it took for loops;
/// times.yaml. A frame a tenth of a second; cameras at height 0. Throws sim::FileError.
void WriteDrive(const std::filesystem::path& folder, const PlayedDrive& drive);

bool HasDrive(const std::filesystem::path& folder);
/// Throws sim::FileError.
DriveResult ReadDriveResult(const std::filesystem::path& folder);

/// A pair of NAME.csv.
std::vector<LoopRecord> ReadLoops(const std::filesystem::path& file);

}  // namespace bulletnav::bench
