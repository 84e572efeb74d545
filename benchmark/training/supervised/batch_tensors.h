// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/model_config.h"
#include "agent/perception/torch.h"
#include "benchmark/training/supervised/pair_batch.h"

namespace bulletnav::bench {

/// The panoramas of a batch as a model takes them.
torch::Tensor InputOf(const agent::ModelConfig& config, PairBatch* batch);

}  // namespace bulletnav::bench
