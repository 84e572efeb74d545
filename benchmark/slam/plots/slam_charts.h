// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "benchmark/report/figure.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// Precision at a recall or more, the mean over drives, of every detector, with the line of
/// guessing; a panel for each kind of loop. The paper's figure 7.
Figure PrecisionRecallFigure(const SlamConfig& config, std::span<const DriveResult> results);

/// Average precision by how far the later camera is turned, the mean over drives, with that of
/// guessing. The question of the paper's figure 6.
Figure HeadingFigure(const SlamConfig& config, std::span<const DriveResult> results);

}  // namespace bulletnav::bench
