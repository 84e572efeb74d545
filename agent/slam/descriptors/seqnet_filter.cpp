// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/seqnet_filter.h"

#include <algorithm>
#include <cstddef>

#include "agent/models/config_in_weights.h"
#include "agent/slam/descriptors/weight_steps.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {
namespace {

constexpr int kSteps = 1 << 14;
constexpr int kLargestSize = 1024;  // that DirectionOf takes

SeqNetConfig ConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<SeqNetConfig>(weights, kSeqNetKey, file,
                                       "SeqNet's filter; train one with "
                                       "configs/train/seqnet.yaml");
}

int SizeOf(const TensorFile& weights, const std::filesystem::path& file) {
  const auto found = weights.tensors.find("bias");
  if (found != weights.tensors.end()) {
    const auto size = static_cast<int>(found->second.values.size());
    if (size >= 1 && size <= kLargestSize) return size;
  }
  throw sim::FileError(file, "bias", "is missing or has no size: train the filter anew");
}

}  // namespace

void SeqNetConfig::Validate() const {
  if (length < 1 || length > 50) throw sim::KeyError("length", "length must be 1 to 50");
}

SeqNetFilter::SeqNetFilter(const TensorFile& weights, const std::filesystem::path& file)
    : config_(ConfigOf(weights, file)), size_(SizeOf(weights, file)) {
  filter_ = WeightSteps(weights, "filter", {size_, config_.length, size_}, kSteps, file);
  bias_ = WeightSteps(weights, "bias", {size_}, kSteps, file);
}

PictureDescriptor SeqNetFilter::Describe(std::span<const PictureDescriptor> pictures) const {
  const auto size = static_cast<std::size_t>(size_);
  const auto length = static_cast<std::size_t>(config_.length);
  BULLETNAV_CHECK(!pictures.empty() && pictures.size() <= length);
  for (const PictureDescriptor& picture : pictures) BULLETNAV_CHECK_EQ(picture.size(), size);
  const std::size_t missing = length - pictures.size();
  std::vector<std::int64_t> numbers(size);
  for (std::size_t row = 0; row < size; ++row) {
    std::int64_t sum = std::int64_t{bias_[row]} * kDescriptorUnit;
    for (std::size_t k = 0; k < length; ++k) {
      const PictureDescriptor& picture = pictures[k < missing ? 0 : k - missing];
      const std::int32_t* own = filter_.data() + (row * length + k) * size;
      for (std::size_t i = 0; i < size; ++i) sum += std::int64_t{own[i]} * picture[i];
    }
    numbers[row] = sum;
  }
  return DirectionOf(numbers);
}

std::shared_ptr<const SeqNetFilter> LoadSeqNetFilter(const std::filesystem::path& weights) {
  return std::make_shared<const SeqNetFilter>(ReadTensorFile(weights), weights);
}

}  // namespace bulletnav::agent
