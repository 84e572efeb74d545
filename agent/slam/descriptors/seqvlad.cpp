// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/seqvlad.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "agent/integer/integer_functions.h"
#include "agent/integer/quantised_file.h"
#include "agent/slam/descriptors/weight_steps.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

/// Of a cell. Fine, since what clusters have little of counts as much as the rest.
constexpr int kShareSteps = 1 << 24;
constexpr int kAssignSteps = 1 << 12;
constexpr int kProjectionSteps = 1 << 14;

/// The numbers of the rows that a file holds in 8 bits.
TensorFile Widened(const TensorFile& weights, const std::filesystem::path& file) {
  const QuantisedNet net = ReadQuantised(weights, file);
  const QuantisedLayer& layer = MadeOfIntegers(file, "train the descriptor again", [&] {
    return net.Layer(kProjection);
  });
  TensorFile::Tensor wide{{layer.outputs, std::int64_t{layer.segments} * layer.inputs}, {}};
  wide.values.reserve(layer.weights.size());
  const std::size_t row = layer.weights.size() / static_cast<std::size_t>(layer.outputs);
  for (std::size_t i = 0; i < layer.weights.size(); ++i) {
    wide.values.push_back(static_cast<float>(layer.weights[i]) * layer.scale[i / row]);
  }
  TensorFile content;
  content.tensors[kProjection] = std::move(wide);
  return content;
}

}  // namespace

SeqVlad::SeqVlad(const TensorFile& weights, const std::filesystem::path& file)
    : config_(SequenceConfigOf(weights, file)) {
  const std::vector<std::int64_t> clusters = {config_.clusters, config_.channels};
  assign_ = WeightSteps(weights, "assign", clusters, kAssignSteps, file);
  centres_ = WeightSteps(weights, "centres", clusters, kDescriptorUnit, file);
  mean_ = WeightSteps(weights, "mean", {config_.whole()}, kDescriptorUnit, file);
  const std::vector<std::int64_t> projection = {config_.size, config_.whole()};
  const bool is_wide = weights.tensors.contains(kProjection);
  projection_ = WeightSteps(is_wide ? weights : Widened(weights, file), kProjection, projection,
                            kProjectionSteps, file);
}

void SeqVlad::Add(std::span<const std::uint8_t> cells, Sum* sum) const {
  const auto channels = static_cast<std::size_t>(config_.channels);
  const auto clusters = static_cast<std::size_t>(config_.clusters);
  BULLETNAV_CHECK(!cells.empty() && cells.size() % channels == 0);
  sum->resize(clusters * channels, 0);
  std::vector<std::int32_t> logits(clusters);
  std::vector<float> shares(clusters);
  for (std::size_t first = 0; first < cells.size(); first += channels) {
    const auto bytes = cells.subspan(first, channels);
    const PictureDescriptor cell =
        DirectionOf(std::vector<std::int64_t>(bytes.begin(), bytes.end()));
    for (std::size_t k = 0; k < clusters; ++k) logits[k] = LogitOf(cell, k);
    SoftmaxOf(logits, shares);
    for (std::size_t k = 0; k < clusters; ++k) {
      const auto share = static_cast<std::int64_t>(std::nearbyint(double{shares[k]} * kShareSteps));
      if (share != 0) AddShare(cell, k, share, sum);
    }
  }
}

std::int32_t SeqVlad::LogitOf(const PictureDescriptor& cell, std::size_t cluster) const {
  std::int64_t dot = 0;
  const std::size_t first = cluster * cell.size();
  for (std::size_t i = 0; i < cell.size(); ++i) dot += std::int64_t{assign_[first + i]} * cell[i];
  // Steps of 2^-26 to those of 2^-kLogitBits.
  return static_cast<std::int32_t>(dot / (1 << (26 - kLogitBits)));
}

void SeqVlad::AddShare(const PictureDescriptor& cell, std::size_t cluster, std::int64_t share,
                       Sum* sum) const {
  const std::size_t first = cluster * cell.size();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    (*sum)[first + i] += share * (cell[i] - centres_[first + i]);
  }
}

std::vector<std::int16_t> SeqVlad::Whole(const Sum& sum) const {
  const auto channels = static_cast<std::size_t>(config_.channels);
  BULLETNAV_CHECK_EQ(sum.size(), static_cast<std::size_t>(config_.whole()));
  std::vector<std::int16_t> whole;
  whole.reserve(sum.size());
  for (std::size_t first = 0; first < sum.size(); first += channels) {
    const PictureDescriptor cluster = DirectionOf(std::span(sum).subspan(first, channels));
    whole.insert(whole.end(), cluster.begin(), cluster.end());
  }
  return whole;
}

PictureDescriptor SeqVlad::Describe(const Sum& sum) const {
  const std::vector<std::int16_t> whole = Whole(sum);
  // All clusters have one length, so that the whole's is known.
  const auto factor = 1.0 / std::sqrt(static_cast<double>(config_.clusters));
  const auto length = static_cast<std::int64_t>(std::nearbyint(factor * (1 << 15)));
  std::vector<std::int64_t> off(whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) off[i] = ((whole[i] * length) >> 15) - mean_[i];
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(config_.size), 0);
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    for (std::size_t i = 0; i < off.size(); ++i) {
      numbers[row] += off[i] * projection_[row * off.size() + i];
    }
  }
  return DirectionOf(numbers);
}

std::shared_ptr<const SeqVlad> LoadSeqVlad(const std::filesystem::path& weights) {
  return std::make_shared<const SeqVlad>(ReadTensorFile(weights), weights);
}

}  // namespace bulletnav::agent
