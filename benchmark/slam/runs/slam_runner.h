// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "benchmark/episodes/made_houses.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

struct SlamRunOptions {
  int workers = 0;         // < 1: one per processor
  StartProgress progress;  // may be empty
};

/// Makes houses, grows the vocabulary and plays every drive of a config that `folder` has no result
/// of yet; a folder a drive, below `folder`/drives. Results depend on the config alone, not on
/// workers or on how often the run was stopped. Throws sim::FileError, also if the folder holds
/// results of another config, and sim::FolderBusy.
std::vector<DriveResult> RunSlam(const SlamConfig& config, const std::filesystem::path& folder,
                                 const SlamRunOptions& options);

/// The config and the results of a folder, in the order of its drives. Throws sim::FileError if it
/// holds none.
SlamConfig ReadSlamRun(const std::filesystem::path& folder);
std::vector<DriveResult> ReadSlamResults(const SlamConfig& config,
                                         const std::filesystem::path& folder);
std::filesystem::path DriveFolder(const std::filesystem::path& folder, const std::string& drive);

}  // namespace bulletnav::bench
