// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "agent/integer/quantised_layer.h"
#include "agent/models/safetensors.h"
#include "agent/perception/trunk.h"
#include "agent/slam/descriptors/descriptor_config.h"

namespace bulletnav::agent {

/// What learns to describe flat pictures, so that those of one place look alike: the convolutions
/// of ResNet18, GeM with a learned exponent over the cells of the last stage, one layer, length 1.
/// The same configuration and seed give the same weights on every machine. GeM: see Gem.
class DescriptorNet : public torch::nn::Module {
 public:
  DescriptorNet(const DescriptorConfig& config, std::uint64_t seed);

  const DescriptorConfig& config() const { return config_; }
  /// From DescriptorInput to [n, size], each of length 1.
  torch::Tensor forward(const torch::Tensor& input);
  /// For inference only: see ConvNorm::Fold.
  void Fold();

  /// Takes the trunk of a semantic model, trained on panoramas of colour, of the same width; or all
  /// of a descriptor's of the same shape. Throws FileError if the weights are of another kind or
  /// shape, or in integers alone.
  void StartFrom(const std::filesystem::path& weights);

 private:
  torch::ScalarType ComputeType() const;

  DescriptorConfig config_;
  std::shared_ptr<agent::Trunk> trunk_;
  torch::Tensor exponent_;
  std::shared_ptr<Dense> out_;
};

/// [n, 3, rows, cols] in channels_last memory of pictures [n, rows, cols, 3] that ShrinkPicture
/// made.
torch::Tensor DescriptorInput(const DescriptorConfig& config,
                              std::span<const std::uint8_t> pictures);

/// A file of weights holds the configuration as YAML in its metadata under kDescriptorKey.
void SaveDescriptor(const DescriptorNet& net, std::map<std::string, std::string> notes,
                    StoredType type, const std::filesystem::path& file);
/// Throws FileError, also if the configuration is missing or bad.
std::shared_ptr<DescriptorNet> LoadDescriptor(const std::filesystem::path& file);

/// The network in integers that a trained one becomes; see PictureDescriber. Scales are from what
/// it makes of `input`.
QuantisedNet Quantise(const DescriptorNet& net, const torch::Tensor& input);

}  // namespace bulletnav::agent
