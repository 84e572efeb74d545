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
/// of yet; a folder a drive, below `folder`/drives. A config that adds detectors to the one that is
/// there goes on with its results and plays those alone, see OnlyAddsDetectors. Results depend on
/// the config alone, not on workers or on how often the run was stopped. Throws sim::FileError,
/// also if the folder holds results of another config, or of recordings or weights that have
/// changed since, see KeepFingerprints; and sim::FolderBusy.
std::vector<DriveResult> RunSlam(const SlamConfig& config, const std::filesystem::path& folder,
                                 const SlamRunOptions& options);

/// The config of a folder of results. Throws sim::FileError if it holds none.
SlamConfig ReadSlamRun(const std::filesystem::path& folder);

/// The drives that a folder holds results of, in the order of the config. Scenes and recordings
/// need not be there any more: drives are then in the order of their names, without a source.
std::vector<Drive> DrivesDone(const SlamConfig& config, const std::filesystem::path& folder);

/// Their results. Throws sim::FileError if there are none.
std::vector<DriveResult> ReadSlamResults(const SlamConfig& config,
                                         const std::filesystem::path& folder);
std::filesystem::path DriveFolder(const std::filesystem::path& folder, const std::string& drive);

}  // namespace bulletnav::bench
