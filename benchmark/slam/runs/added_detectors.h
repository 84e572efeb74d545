// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/slam/runs/drive_play.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// Whether `config` goes on with what `before` has played: it has all of its detectors and all else
/// is the same, but for more detectors, weights that only those use, rows from papers, and a
/// detector to compare with where there was none.
bool OnlyAddsDetectors(const SlamConfig& before, const SlamConfig& config);

/// Whether a drive's result has a row of every detector, and no other.
bool HasAllRows(const SlamConfig& config, const DriveResult& result);

/// The config with those detectors alone that a drive's result lacks, and the one to compare with,
/// by whose scores others' stages are measured.
SlamConfig WithMissingRows(SlamConfig config, const DriveResult& result);

/// Puts the rows of an earlier result before those that were played since, in the config's order;
/// likewise the times. A detector that has been played twice keeps its earlier row.
void AddEarlierRows(const SlamConfig& config, const DriveResult& earlier, const TimesByStage& times,
                    PlayedDrive* played);

}  // namespace bulletnav::bench
