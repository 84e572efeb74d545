// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// How every detector differs from `config.against`, as Markdown: how well it ranks covisible pairs
/// and how far trajectories are off, means over scenes of what drives of a scene have in the mean,
/// with 95% intervals bootstrapped over scenes. Only drives that have the figure of both count.
/// Empty if the config asks for none. Expects: drives whose truth is known.
std::string ComparisonTable(const SlamConfig& config,
                            const std::vector<const DriveResult*>& results);

/// What each stage of detectors with sequences loses against `config.against`, as Markdown, means
/// over drives; see StageOutcome. Empty if there is none. Expects: as above.
std::string StageTable(const SlamConfig& config, const std::vector<const DriveResult*>& results);

}  // namespace bulletnav::bench
