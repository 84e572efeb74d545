// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// FileHash by file, of what a config names and does not hold: the lists and poses of recordings,
/// and weights. Files that are not there have none.
using SlamFingerprints = std::map<std::string, std::string>;
SlamFingerprints FingerprintsOf(const SlamConfig& config);

/// Writes fingerprints.yaml of a folder of results, or sees that it says the same. A folder without
/// it gets it. Throws sim::FileError that names a file which has changed since the run began.
void KeepFingerprints(const SlamConfig& config, const std::filesystem::path& folder);

}  // namespace bulletnav::bench
