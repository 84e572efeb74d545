// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// Means over drives, as Markdown: for each length of drives the trajectory errors in the layout of
/// the paper's table I, between odometry alone and the bound by true loops; then how well each
/// detector ranks pairs, by each truth beside guessing, and by heading; then what the config asks
/// to compare (slam_comparison.h). Drives whose truth is not known are counted and left out.
std::string SlamTables(const SlamConfig& config, std::span<const DriveResult> results);

/// Milliseconds a frame of each stage, means over drives, as Markdown; empty if no drive has times.
/// Apart from the tables above, since they depend on the machine.
std::string SlamTimesTable(const SlamConfig& config, std::span<const TimesByStage> times);

}  // namespace bulletnav::bench
