// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "agent/observation.h"
#include "agent/perception/model_config.h"
#include "agent/perception/trunk.h"

namespace bulletnav::agent {

/// Panoramas to twelve patch codes each. Patch i is 90 degrees wide and centred at bearing
/// 2 pi i / 12, counter-clockwise from straight ahead; since columns go clockwise from behind, its
/// middle is column cols (1/2 - i/12).
/// Form kPanorama averages the trunk's features over the patch; a turn by 90 degrees permutes the
/// codes exactly, by 30 degrees nearly. The map has 4 x 16 cells whatever the size of the input.
/// Then two fully connected layers, 256 and 128 wide, with dropout and ReLU.
/// Source: Neural Topological SLAM, appendix A and figure 11; kPanorama and the 256 are ours.
class Encoder : public torch::nn::Module {
 public:
  Encoder(const ModelConfig& config, sim::Rng* rng);

  /// From PrepareInput to [n, 12, kCodeSize]. Dropout only with a generator.
  torch::Tensor forward(const torch::Tensor& input, std::optional<at::Generator> dropout = {});
  void Fold(torch::ScalarType type);

 private:
  torch::Tensor Features(const torch::Tensor& pictures);
  torch::Tensor PatchFeatures(const torch::Tensor& input);

  ModelConfig config_;
  std::shared_ptr<Trunk> trunk_;
  std::shared_ptr<Trunk> depth_trunk_;     // null unless depth is separate
  std::shared_ptr<ConvNorm> depth_mixer_;  // as above
  std::shared_ptr<Dense> first_;
  std::shared_ptr<Dense> second_;
  torch::Tensor pooling_;       // kPanorama: [12, 16] shares of the map's columns
  torch::Tensor crop_columns_;  // kPatches: [12 * rows] columns of the patches, one after the other
};

/// The input of an encoder, [n, channels, rows, cols] in channels_last memory: red, green and blue,
/// then depth if it is used. `color` is u8 [n, 128, 512, 3]; `depth` is float32 [n, 128, 512] in
/// metres, not read if unused. Depth counts up to 10 m; no return (0) stays apart from that.
torch::Tensor PrepareInput(const ModelConfig& config, const torch::Tensor& color,
                           const torch::Tensor& depth);
/// Of one panorama, [1, channels, rows, cols].
torch::Tensor PrepareInput(const ModelConfig& config, const Panorama& panorama);

/// The trunk of a configuration, for pictures of `in` channels.
Trunk::Shape TrunkShape(const ModelConfig& config, int in);

/// What the trunk computes in on this machine.
torch::ScalarType ComputeType(const ModelConfig& config);

}  // namespace bulletnav::agent
