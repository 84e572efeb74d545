// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/perception/layers.h"
#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// What the heads need of panoramas, all that does not take a pair: of n panoramas,
struct PanoramaParts {
  torch::Tensor explorable;    // [n, 12] logits
  torch::Tensor source_sum;    // [n, 12, pair_features]
  torch::Tensor goal_sum;      // as above
  torch::Tensor source_match;  // [n, 12, kMatches * kMatchSize]
  torch::Tensor goal_match;    // as above

  PanoramaParts Select(const torch::Tensor& indices) const;
};

/// Of n pairs.
struct PairOutputs {
  torch::Tensor same_node;       // [n] logits
  torch::Tensor direction;       // [n, 12] logits
  torch::Tensor distance_score;  // [n] in [0, 1]: 1 - d / 3 m
  torch::Tensor scores;          // [n, 12] in [0, 1]: 1 - d_i / 20 m
};

/// The connection, intra-node and inter-node models of Neural Topological SLAM, appendix A. Their
/// layers are not in its text; these are ours. For each direction i of the source and each turn r
/// of the goal against it, all 24 codes, turned so that i comes first, go through two layers:
///   h(i, r) = relu(W relu(A source_i + B goal_(i+r) + M matches(i, r) + b) + c),
/// where source_i is the twelve codes from i on, and matches are scalar products of the source's
/// patches with those of the goal that then look the same way, and with their neighbours. The
/// maximum and the mean over r describe direction i: turning the source turns the answers with
/// it, turning the goal changes nothing. The connection and the distance take the maximum and the
/// mean over i as well. Explorable directions take three neighbouring patches of the source.
class Heads : public torch::nn::Module {
 public:
  static constexpr int kMatches = 4;     // scalar products a pair of patches
  static constexpr int kMatchSize = 32;  // numbers in each

  Heads(const ModelConfig& config, sim::Rng* rng);

  /// From codes [n, 12, kCodeSize].
  PanoramaParts Describe(const torch::Tensor& codes);
  /// Pair k is panorama k of each.
  PairOutputs Compare(const PanoramaParts& sources, const PanoramaParts& goals);

 private:
  /// relu and a second layer.
  struct Pair {
    std::shared_ptr<Dense> hidden;
    std::shared_ptr<Dense> out;
    torch::Tensor operator()(const torch::Tensor& x) const;  // [..., in] to [...]
  };
  Pair AddPair(const std::string& name, int in, sim::Rng* rng);
  torch::Tensor Matches(const torch::Tensor& source, const torch::Tensor& goal);

  int features_;
  Pair explorable_;
  Pair direction_;
  Pair score_;
  Pair connection_;
  Pair distance_;
  std::shared_ptr<Dense> source_sum_;
  std::shared_ptr<Dense> goal_sum_;
  std::shared_ptr<Dense> source_match_;
  std::shared_ptr<Dense> goal_match_;
  std::shared_ptr<Dense> matches_;
  std::shared_ptr<Dense> second_;
};

}  // namespace bulletnav::agent
