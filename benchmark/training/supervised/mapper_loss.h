// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "benchmark/training/supervised/true_free_space.h"

namespace bulletnav::bench {

/// The truth about a batch's panoramas as the net answers it: [count, 2, 128, 128] float 0 or 1,
/// explored, then obstacle. Expects: a batch with depth (checked).
torch::Tensor FreeSpaceLabels(const PairBatch& batch, TrueFreeSpace* truth);

/// [128, 128] cells within 3.2 m, those that count.
torch::Tensor CellsInReach();

/// Binary cross-entropies of net answers; means over cells and panoramas.
struct MapperLosses {
  torch::Tensor explored;  // over all cells in reach
  torch::Tensor obstacle;  // over those that are explored; obstacles count `obstacle_weight` times

  torch::Tensor Total() const { return explored + obstacle; }
};

/// Trains whether a cell is an obstacle only where it is seen: so answers near a wall whose place
/// is not quite known do not fade away between "not an obstacle" before and "unseen" behind it.
/// The weight is for obstacles being one cell thick: with 3, one that is there with probability
/// 1/4 counts as such. Source: binary cross-entropy, Active Neural SLAM; the rest is ours.
MapperLosses LossesOf(const torch::Tensor& answers, const torch::Tensor& labels,
                      double obstacle_weight);

}  // namespace bulletnav::bench
