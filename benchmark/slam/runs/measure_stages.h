// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "agent/slam/loops/loop_detector.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/truth/loop_truth.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// What is lost where frames are compared in joined sequences alone, with one stage after the other
/// replaced by the truth. `flat` are the pairs of a detector that compares all frames; true places
/// are groups of frames within 2 m and 45 degrees of the group's first, walls or not. Nothing if no
/// pair is covisible. Expects: a pose a frame, sequences that together are all frames (checked).
std::optional<StageOutcome> MeasureStages(const agent::SequenceTrace& trace,
                                          std::span<const agent::LoopCandidate> flat,
                                          const LoopTruth& truth,
                                          std::span<const sim::BodyPose> poses);

}  // namespace bulletnav::bench
