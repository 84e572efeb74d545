// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <optional>
#include <span>
#include <vector>

#include "agent/slam/loops/loop_detector.h"
#include "benchmark/slam/runs/back_end.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/truth/loop_truth.h"

namespace bulletnav::bench {

/// The pairs that a detector named, against the truth: what it never names is not found.
void MeasureRanking(std::span<const agent::LoopCandidate> named, const LoopTruth& truth,
                    bool has_nodes, DetectorResult* result);

/// Laid over where the body truly was.
BothErrors MeasureBoth(std::span<const sim::BodyPose> truth,
                       std::span<const sim::PlanarPose> estimate);

/// Whether a motion between two frames is off by more than half a metre or 10 degrees.
bool IsOff(const MeasuredLoop& loop, std::span<const sim::BodyPose> truth);

/// What a perfect front end would find: for every tenth frame the first covisible one before it.
std::vector<MeasuredLoop> TrueLoops(std::span<const TruthFrame> frames, const LoopTruth& truth);

double MillisecondsSince(std::chrono::steady_clock::time_point start);
/// Median and 95th percentile; zeros of nothing.
StageTimes TimesOf(std::vector<double> milliseconds);

}  // namespace bulletnav::bench
