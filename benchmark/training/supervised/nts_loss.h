// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/perception/heads.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// Some ordered pairs of a batch and their labels, in tensors. Indices and labels of n pairs, and
/// of all the panoramas.
struct LabelledPairs {
  torch::Tensor source;          // [n] int64, panorama
  torch::Tensor goal;            // likewise
  torch::Tensor same_node;       // [n] float 0 or 1
  torch::Tensor direction;       // [n] int64, -1 = none
  torch::Tensor distance_score;  // [n] of pairs of one node
  torch::Tensor scores;          // [n, 12] of other pairs, -1 = none
  torch::Tensor explorable;      // [panoramas, 12] float 0 or 1
};

/// Pairs of two different panoramas, as indices source * count + goal: all of them, or
/// `count_pairs` drawn without putting back, half of them of one node if there are as many.
std::vector<int> AllPairs(const PairBatch& batch);
std::vector<int> DrawPairs(const PairBatch& batch, int count_pairs, sim::Rng rng);

LabelledPairs Labels(const PairBatch& batch, const std::vector<int>& pairs);
/// Of several batches with as many panoramas each, as if of one.
LabelledPairs Join(const std::vector<LabelledPairs>& parts);

/// Means over what has a label; zero where nothing has.
struct NtsLosses {
  torch::Tensor connection;  // cross-entropy, both answers weighing the same
  torch::Tensor direction;   // cross-entropy
  torch::Tensor explorable;  // cross-entropy
  torch::Tensor distance;    // square of the score's error
  torch::Tensor scores;      // likewise
  torch::Tensor contrast;    // likewise, of the scores less their mean over the directions
  torch::Tensor rejection;   // square of the distance's score where the pair is of two nodes

  /// The sum, squares counting ten times. Source: Neural Topological SLAM, appendix A; the weighed
  /// ones are ours.
  struct Weights {
    double contrast = 0.0;
    double rejection = 0.0;
  };
  torch::Tensor Total(const Weights& weights) const;
  torch::Tensor Total() const { return Total({}); }
};

/// Trains the direction and distance on pairs of one node only, the scores on others only.
NtsLosses Losses(const torch::Tensor& explorable, const agent::PairOutputs& outputs,
                 const LabelledPairs& labels);

}  // namespace bulletnav::bench
