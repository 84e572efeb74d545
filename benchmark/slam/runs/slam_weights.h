// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/slam/retrieval/sequence_filter.h"
#include "agent/slam/retrieval/sequence_model.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// The model of sequences that a config names; null where it names none. Throws sim::FileError if
/// it is not there, cannot be used, or was trained on another descriptor than the config's.
std::shared_ptr<const agent::SequenceModel> LoadSequences(const SlamConfig& config);
/// The same of the filter over time.
std::shared_ptr<const agent::SequenceFilter> LoadFilter(const SlamConfig& config);

/// Throws sim::FileError if weights that a config names are not there, or do not go together.
void CheckWeights(const SlamConfig& config);

}  // namespace bulletnav::bench
