// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/perception/layers.h"
#include "agent/policy/policy_map.h"

namespace bulletnav::agent {

/// What a policy makes of its map: three convolutions of stride 2, the same for both crops, and a
/// fully connected layer. In float32, without normalisation: a rollout and its update must agree.
class MapBranch : public torch::nn::Module {
 public:
  /// Channels and sides before and after each convolution; the fourth plane is empty, so that
  /// integers fill whole words.
  static constexpr std::array kChannels = {4, 16, 32, 32};
  static constexpr int kEndSide = kMapSide / 8;
  static constexpr int kEndSize = kMapCrops * kEndSide * kEndSide * kChannels.back();

  explicit MapBranch(sim::Rng* rng);

  /// Bytes of PolicyMap as numbers, [n, kPolicyMapBytes], to [n, kMapFeatures], positive.
  torch::Tensor forward(const torch::Tensor& bytes);

  /// The planes [n * kMapCrops, 4, kMapSide, kMapSide] that bytes stand for.
  static torch::Tensor Planes(const torch::Tensor& bytes);
  /// What convolutions come to, [n * kMapCrops, channels, side, side], as the last layer takes it.
  static torch::Tensor Flat(const torch::Tensor& ends);

 private:
  class Conv;
  std::vector<std::shared_ptr<Conv>> convs_;
  std::shared_ptr<Dense> whole_;
};

/// Names of the convolutions within the branch, in their order; then comes "whole".
inline constexpr std::array kMapConvs = {"first", "second", "third"};

}  // namespace bulletnav::agent
