// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// FileHash by file, of what a config names and does not hold: scenes, the lists and poses of
/// recordings, and weights. Files that are not there have none.
using SlamFingerprints = std::map<std::string, std::string>;
SlamFingerprints FingerprintsOf(const SlamConfig& config);

/// Those of now, which are what fingerprints.yaml of a folder of results says, or more: weights of
/// detectors that were added, scenes where an earlier version noted none. Throws sim::FileError
/// that names a file which has changed since the run began.
SlamFingerprints CheckFingerprints(const SlamConfig& config, const std::filesystem::path& folder);

/// Writes fingerprints.yaml; of a folder that has results after CheckFingerprints.
void KeepFingerprints(const SlamConfig& config, const std::filesystem::path& folder, bool is_new);

}  // namespace bulletnav::bench
