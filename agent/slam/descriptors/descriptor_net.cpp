// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/descriptor_net.h"

#include <algorithm>
#include <string>
#include <vector>

#include "agent/perception/encoder.h"
#include "agent/perception/model_file.h"
#include "agent/perception/quantise_trunk.h"
#include "agent/perception/weights.h"
#include "agent/slam/descriptors/gem.h"
#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {
namespace {

constexpr double kFirstExponent = 3.0;
constexpr double kLeastActivation = 1e-4;  // whose powers still have a gradient
constexpr double kRoom = 2.0;              // for numbers larger than all of calibration
constexpr int kWhole16 = 32767;
constexpr const char* kTrunk = "trunk.";
constexpr const char* kModelTrunk = "encoder.trunk.";  // of semantic models

/// [n, channels, rows, cols] to [n, channels].
torch::Tensor Pooled(const torch::Tensor& map, const torch::Tensor& exponent) {
  const torch::Tensor p = exponent.clamp(kLeastExponent, kMostExponent);
  return map.clamp_min(kLeastActivation).pow(p).mean(at::IntArrayRef{2, 3}).pow(1.0 / p);
}

}  // namespace

DescriptorNet::DescriptorNet(const DescriptorConfig& config, std::uint64_t seed) : config_(config) {
  sim::Rng rng(seed, "descriptor_net");
  const agent::Trunk::Shape shape = {3, config.width, kDescriptorHalvings, Ends::kZeros,
                                     Norm::kBatch};
  trunk_ = register_module("trunk", std::make_shared<agent::Trunk>(shape, &rng));
  exponent_ = register_parameter("exponent", at::full({1}, kFirstExponent));
  out_ = register_module("out", std::make_shared<Dense>(8 * config.width, config.size, &rng));
}

torch::ScalarType DescriptorNet::ComputeType() const {
  ModelConfig config;
  config.precision = config_.precision;
  return agent::ComputeType(config);
}

torch::Tensor DescriptorNet::forward(const torch::Tensor& input) {
  const torch::Tensor map = trunk_->forward(input.to(ComputeType())).to(torch::kFloat32);
  const torch::Tensor numbers = out_->forward(Pooled(map, exponent_));
  return numbers / numbers.norm(2, {1}, true).clamp_min(1e-6);
}

void DescriptorNet::Fold() {
  trunk_->Fold(ComputeType());
}

void DescriptorNet::StartFrom(const std::filesystem::path& weights) {
  const TensorFile content = ReadTensorFile(weights);
  if (content.metadata.contains(kDescriptorKey)) {
    const DescriptorConfig own = DescriptorConfigOf(content, weights);
    if (own.width != config_.width || own.size != config_.size) {
      throw sim::FileError(weights, "",
                           "is of a descriptor of another width or size; set 'model' to " +
                               std::to_string(own.width) + " and " + std::to_string(own.size));
    }
    SetWeights(content, "", weights, this);
    return;
  }
  const ModelConfig model = ModelConfigOf(content, weights);
  if (model.width != config_.width || model.uses_depth()) {
    throw sim::FileError(weights, "",
                         "is of another width, or of a model that sees depth; name "
                         "weights of colour alone of width " +
                             std::to_string(config_.width));
  }
  TensorFile trunk;
  for (const auto& [name, tensor] : content.tensors) {
    if (!name.starts_with(kModelTrunk)) continue;
    trunk.tensors[name] = tensor;
  }
  SetWeights(trunk, kModelTrunk, weights, trunk_.get());
}

torch::Tensor DescriptorInput(const DescriptorConfig& config,
                              std::span<const std::uint8_t> pictures) {
  const std::int64_t picture = std::int64_t{config.rows} * config.cols() * 3;
  const auto bytes = static_cast<std::int64_t>(pictures.size());
  if (bytes % picture != 0) throw sim::Error("pictures are not of the descriptor's size");
  const torch::Tensor whole =
      torch::empty({bytes / picture, config.rows, config.cols(), 3}, torch::kUInt8);
  std::copy(pictures.begin(), pictures.end(), whole.data_ptr<std::uint8_t>());
  // As in PrepareInput: half of the range is 0, steps of 4 / 254.
  return ((whole.to(torch::kFloat32) - 127.0f) * (4.0f / 254.0f)).permute({0, 3, 1, 2});
}

void SaveDescriptor(const DescriptorNet& net, std::map<std::string, std::string> notes,
                    StoredType type, const std::filesystem::path& file) {
  notes[kDescriptorKey] = sim::ToYaml(net.config());
  SaveWeights(net, std::move(notes), type, file);
}

std::shared_ptr<DescriptorNet> LoadDescriptor(const std::filesystem::path& file) {
  const TensorFile content = ReadTensorFile(file);
  auto net = std::make_shared<DescriptorNet>(DescriptorConfigOf(content, file), 0);
  SetWeights(content, "", file, net.get());
  return net;
}

QuantisedNet Quantise(const DescriptorNet& net, const torch::Tensor& input) {
  const c10::InferenceMode inference;
  Quantiser quantiser(net);
  const torch::Tensor map =
      quantiser.FlatTrunk(kTrunk, input.to(torch::kFloat32), kDescriptorHalvings).back();
  const torch::Tensor exponent = quantiser.Weight("exponent").clamp(kLeastExponent, kMostExponent);
  const double step = quantiser.net()->Scale("trunk.stage4_2_second") / (1 << Gem::kBits);
  quantiser.net()->scales["exponent"] = exponent.item<float>();
  quantiser.Dense16("out", step, Gem::kLargest);
  const torch::Tensor numbers = at::linear(Pooled(map, exponent), quantiser.Weight("out.weight"),
                                           quantiser.Weight("out.bias"));
  quantiser.RoomyScale("out", numbers, kWhole16, kRoom);
  return *quantiser.net();
}

}  // namespace bulletnav::agent
