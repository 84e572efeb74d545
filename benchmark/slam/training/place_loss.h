// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"
#include "benchmark/slam/training/place_config.h"

namespace bulletnav::bench {

/// Multi-similarity loss of descriptors [n, size] of length 1, mean over the views; see
/// SimilarityLossSpec. `covisibility` [n, n]: from kSamePlace on two views are to be alike, up to
/// kOtherPlace unlike. A positive counts if it is less alike than the most alike negative and
/// `margin`, a negative if it is more alike than the least alike positive less `margin`.
torch::Tensor SimilarityLoss(const torch::Tensor& descriptors, const torch::Tensor& covisibility,
                             const SimilarityLossSpec& spec);

}  // namespace bulletnav::bench
