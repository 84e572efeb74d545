// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "agent/slam/loops/loop_detector.h"
#include "benchmark/slam/truth/loop_truth.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// How like each other the frames of a drive are, as a grey picture of at most 256 x 256: row and
/// column are frames, the brighter, the higher the best score among the pairs that fall together;
/// white is the drive's best. Both halves are filled.
sim::Image SimilarityMatrix(std::span<const agent::LoopCandidate> named, int frames);
/// Covisible pairs by the truth, likewise: white where there is one.
sim::Image CovisibleMatrix(const LoopTruth& truth);

/// NAME.sequences.yaml in the drive's folder; nothing is written of a drive without sequences.
/// Reading gives nothing if there is no such file. Throw sim::FileError.
void WriteTrace(const std::filesystem::path& folder, const std::string& name,
                const agent::SequenceTrace& trace);
agent::SequenceTrace ReadTrace(const std::filesystem::path& folder, const std::string& name);

}  // namespace bulletnav::bench
