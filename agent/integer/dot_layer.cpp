// SPDX-License-Identifier: MIT
#include "agent/integer/dot_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kLargestInt = 2147483647.0;
constexpr std::size_t kSumsAtATime = 8192;  // 32 KiB

void RequireSizes(const QuantisedLayer& layer, LayerWidth width) {
  const auto outputs = static_cast<std::size_t>(layer.outputs);
  const auto values =
      static_cast<std::size_t>(layer.segments) * static_cast<std::size_t>(layer.inputs) * outputs;
  if (layer.outputs < 1 || layer.segments < 1 || layer.inputs < 1 ||
      layer.weights.size() != values || layer.scale.size() != outputs ||
      layer.bias.size() != outputs) {
    throw sim::Error("weights, scales and biases are not as many as the layer has");
  }
  const int largest = width == LayerWidth::k8 ? kLargestWeight8 : 32767;
  const auto is_small = [&](std::int16_t weight) {
    return std::abs(int{weight}) <= largest;
  };
  if (!std::all_of(layer.weights.begin(), layer.weights.end(), is_small)) {
    throw sim::Error("a weight is larger than " + std::to_string(largest));
  }
}

/// The most bits that leave largest * 2^bits within 31 bits, of 1 to 32.
int ShiftFor(double largest) {
  if (!(largest > 0.0 && largest < 0.25 * kLargestInt)) throw sim::Error("a scale is out of range");
  return std::min(32, 30 - std::ilogb(largest));
}

std::int32_t FactorOf(double ratio, int shift) {
  return static_cast<std::int32_t>(std::min(kLargestInt, std::nearbyint(std::ldexp(ratio, shift))));
}

}  // namespace

DotLayer::DotLayer(const QuantisedLayer& layer, LayerWidth width, const LayerScales& scales)
    : width_(width),
      segments_(layer.segments),
      steps_(0),
      blocks_((layer.outputs + kOutputBlock - 1) / kOutputBlock),
      shift_(0),
      kept_factor_(0),
      kernels_(SupportedIntegerKernels().front()) {
  RequireSizes(layer, width);
  const int per_word = width == LayerWidth::k8 ? 4 : 2;
  if (layer.inputs % per_word != 0) throw sim::Error("inputs do not fill whole words");
  steps_ = layer.inputs / per_word;
  Pack(layer, width);
  SetScales(layer, scales);
}

void DotLayer::Pack(const QuantisedLayer& layer, LayerWidth width) {
  const auto words = static_cast<std::size_t>(segments_ * steps_);
  weights_.assign(words * static_cast<std::size_t>(padded_outputs()), 0);
  const std::size_t per_word = width == LayerWidth::k8 ? 4 : 2;
  const std::size_t bits = 32 / per_word;
  const std::uint32_t mask = (1u << bits) - 1;
  for (std::size_t output = 0; output < static_cast<std::size_t>(layer.outputs); ++output) {
    for (std::size_t word = 0; word < words; ++word) {
      std::uint32_t packed = 0;
      for (std::size_t i = 0; i < per_word; ++i) {
        const auto weight =
            static_cast<std::uint32_t>(layer.weights[(output * words + word) * per_word + i]);
        packed |= (weight & mask) << (bits * i);
      }
      const std::size_t at =
          ((output / kOutputBlock) * words + word) * kOutputBlock + output % kOutputBlock;
      weights_[at] = static_cast<std::int32_t>(packed);
    }
  }
}

void DotLayer::SetScales(const QuantisedLayer& layer, const LayerScales& scales) {
  bias_.assign(static_cast<std::size_t>(padded_outputs()), 0);
  factor_.assign(bias_.size(), 0);
  const std::size_t values = layer.weights.size() / static_cast<std::size_t>(layer.outputs);
  if (!(scales.kept >= 0.0)) throw sim::Error("a scale is not positive");
  const double largest = *std::max_element(layer.scale.begin(), layer.scale.end());
  shift_ = ShiftFor(std::max(scales.in * largest, scales.kept) / scales.out);
  kept_factor_ = FactorOf(scales.kept / scales.out, shift_);
  for (std::size_t output = 0; output < layer.scale.size(); ++output) {
    std::int64_t sum = 0;
    std::int64_t size = 0;
    for (std::size_t i = 0; i < values; ++i) {
      const std::int64_t weight = layer.weights[output * values + i];
      sum += weight;
      size += std::abs(weight);
    }
    const double step = scales.in * layer.scale[output];  // of sums, in real units
    if (!(step > 0.0)) throw sim::Error("a scale is not positive");
    const double bias = std::nearbyint(layer.bias[output] / step) -
                        static_cast<double>(scales.zero) * static_cast<double>(sum);
    const double most = static_cast<double>(size) * scales.largest + std::abs(bias);
    if (!(most <= kLargestInt)) throw sim::Error("sums may not fit into 32 bits");
    bias_[output] = static_cast<std::int32_t>(bias);
    factor_[output] = FactorOf(step / scales.out, shift_);
    // Half of the range, so that there is room for what is kept.
    if (!(most * step / scales.out <= 0.5 * kLargestInt)) {
      throw sim::Error("results may not fit into 32 bits");
    }
  }
}

void DotLayer::Run(const Input& input, const KeptValues& kept, const LayerOutput& output) {
  const auto outputs = static_cast<std::size_t>(padded_outputs());
  const std::size_t at_a_time = std::max<std::size_t>(1, kSumsAtATime / outputs);
  sums_.resize(std::min(at_a_time, input.offsets.size()) * outputs);
  DotJob dots = {.in = static_cast<const std::uint8_t*>(input.in),
                 .offsets = nullptr,
                 .pixels = 0,
                 .segments = segments_,
                 .segment_stride = input.segment_stride,
                 .steps = steps_,
                 .weights = weights_.data(),
                 .blocks = blocks_,
                 .sums = sums_.data()};
  ScaleJob scale = {};
  scale.sums = sums_.data();
  scale.outputs = padded_outputs();
  scale.bias = bias_.data();
  scale.factor = factor_.data();
  scale.kept = kept.values;
  scale.kept2 = kept.values2;
  scale.kept_factor = kept_factor_;
  scale.shift = shift_;
  scale.low = output.low;
  scale.high = output.high;
  scale.out8 = output.bytes;
  scale.out16 = output.fine;
  const auto from = [](const std::int32_t* offsets, std::size_t first) {
    return offsets == nullptr ? nullptr : offsets + first;
  };
  for (std::size_t first = 0; first < input.offsets.size(); first += at_a_time) {
    const auto count = static_cast<std::int32_t>(std::min(at_a_time, input.offsets.size() - first));
    dots.offsets = input.offsets.data() + first;
    dots.pixels = scale.pixels = count;
    (width_ == LayerWidth::k8 ? kernels_->dot8 : kernels_->dot16)(dots);
    scale.kept_offsets = from(kept.offsets, first);
    scale.kept2_offsets = from(kept.offsets2, first);
    scale.out8_offsets = from(output.byte_offsets, first);
    scale.out16_offsets = from(output.fine_offsets, first);
    kernels_->scale(scale);
  }
}

void DotLayer::RunOne(const std::int16_t* in, std::int32_t low, std::int32_t high,
                      std::vector<std::int16_t>* out) {
  constexpr std::array<std::int32_t, 1> kStart = {0};
  out->resize(static_cast<std::size_t>(padded_outputs()));
  LayerOutput output;
  output.fine = out->data();
  output.fine_offsets = kStart.data();
  output.low = low;
  output.high = high;
  Run({in, kStart, 0}, {}, output);
}

}  // namespace bulletnav::agent
