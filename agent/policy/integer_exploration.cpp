// SPDX-License-Identifier: MIT
#include "agent/policy/integer_exploration.h"

#include <algorithm>
#include <limits>

#include "agent/policy/exploration_view.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kBorder = 1;
constexpr double kFineSteps = 1 << kFineBits;
constexpr int kLargestFine = 32767;

std::string ConvName(std::size_t i) {
  return "conv" + std::to_string(i + 1);
}

void RequireSize(const QuantisedNet& net, const std::string& name,
                 const std::array<int, 3>& segments_inputs_outputs) {
  const QuantisedLayer& layer = net.Layer(name);
  if (std::array{layer.segments, layer.inputs, layer.outputs} == segments_inputs_outputs) return;
  throw sim::Error("layer " + name + " does not fit the policy's configuration");
}

void RequireSizes(const ExplorationConfig& config, const QuantisedNet& net) {
  int channels = kExplorationChannels;
  for (std::size_t i = 0; i < kExplorationWidths.size(); ++i) {
    RequireSize(net, ConvName(i), {3, 3 * channels, kExplorationWidths[i]});
    channels = kExplorationWidths[i];
  }
  RequireSize(net, "first", {1, kExplorationCodes + kHeadings, config.features});
  RequireSize(net, "second", {1, config.features, config.features});
  RequireSize(net, "mean", {1, config.features, 2});
}

DotLayer Layer(const QuantisedNet& net, const std::string& name, double in, double out) {
  return {net.Layer(name), LayerWidth::k16, {in, 0, kExplorationLargest, out}};
}

/// The largest values of two pixels beside each other in each of two rows.
void PoolPixel(const std::uint8_t* above, const std::uint8_t* below, int channels,
               std::uint8_t* to) {
  for (int i = 0; i < channels; ++i) {
    to[i] =
        std::max(std::max(above[i], above[i + channels]), std::max(below[i], below[i + channels]));
  }
}

/// The largest of each 2 x 2 pixels.
void Pool(const Pictures& in, Pictures* out) {
  const int channels = in.shape.channels;
  for (int row = 0; row < out->shape.rows; ++row) {
    for (int col = 0; col < out->shape.cols; ++col) {
      const std::uint8_t* above = in.bytes.data() + in.shape.Offset(2 * row, 2 * col);
      PoolPixel(above, above + in.shape.row_stride(), channels,
                out->bytes.data() + out->shape.Offset(row, col));
    }
  }
}

}  // namespace

IntegerExploration::IntegerExploration(const ExplorationConfig& config, const QuantisedNet& net,
                                       std::span<const float> log_deviation)
    : input_({kExplorationSide, kExplorationSide, kExplorationChannels, kBorder}, 1),
      first_(Layer(net, "first", net.Scale("codes"), net.Scale("first"))),
      second_(Layer(net, "second", net.Scale("first"), net.Scale("second"))),
      mean_(Layer(net, "mean", net.Scale("second"), kMeanStep)),
      codes_(static_cast<std::size_t>(kExplorationCodes + kHeadings)) {
  RequireSizes(config, net);
  if (log_deviation.size() != deviation_.size()) throw sim::Error("deviations are not two numbers");
  for (std::size_t i = 0; i < deviation_.size(); ++i) {
    deviation_[i] = sim::Exp(double{log_deviation[i]});
  }
  double step = 1.0;
  convolutions_.reserve(kExplorationWidths.size());
  pooled_.reserve(kExplorationPools);
  for (std::size_t i = 0; i < kExplorationWidths.size(); ++i) {
    const Pictures& in = i == 0                   ? input_
                         : i <= kExplorationPools ? pooled_[i - 1]
                                                  : convolutions_[i - 1].out;
    const bool is_last = i + 1 == kExplorationWidths.size();
    const double out = is_last ? net.Scale("codes") : net.Scale(ConvName(i)) / kFineSteps;
    convolutions_.push_back(MakeConvolution(net.Layer(ConvName(i)), in, step, out));
    if (!is_last) step = net.Scale(ConvName(i));
    if (i >= kExplorationPools) continue;
    PictureShape half = convolutions_.back().out.shape;
    half.rows /= 2;
    half.cols /= 2;
    pooled_.emplace_back(half, 1);
  }
}

IntegerExploration::Convolution IntegerExploration::MakeConvolution(const QuantisedLayer& layer,
                                                                    const Pictures& in,
                                                                    double in_step,
                                                                    double out_step) {
  const PictureShape shape = {in.shape.rows, in.shape.cols, layer.outputs, kBorder};
  return {DotLayer(layer, LayerWidth::k8, {in_step, 0, 255, out_step}),
          PixelOffsets(in.shape, 1, 1, kBorder), Pictures(shape, 1), PixelOffsets(shape, 1)};
}

void IntegerExploration::Convolve(const Pictures& in, Convolution* convolution) {
  LayerOutput output;
  output.bytes = convolution->out.bytes.data();
  output.byte_offsets = convolution->out_offsets.data();
  convolution->layer.Run({in.bytes.data(), convolution->in_offsets, in.shape.row_stride()}, {},
                         output);
}

void IntegerExploration::Use(const IntegerKernels& kernels) {
  for (Convolution& convolution : convolutions_) convolution.layer.Use(kernels);
  for (DotLayer* layer : {&first_, &second_, &mean_}) layer->Use(kernels);
}

GoalDistribution IntegerExploration::Ask(std::span<const std::uint8_t> view, int heading) {
  BULLETNAV_CHECK_EQ(view.size(), kExplorationBytes);
  BULLETNAV_CHECK(heading >= 0 && heading < kHeadings);
  for (int row = 0; row < kExplorationSide; ++row) {
    std::uint8_t* to = input_.bytes.data() + input_.shape.Offset(row, 0);
    for (const std::uint8_t pixel :
         view.subspan(static_cast<std::size_t>(row) * kExplorationSide, kExplorationSide)) {
      for (int i = 0; i < kExplorationChannels; ++i) *to++ = (pixel >> i) & 1;
    }
  }
  const Pictures* in = &input_;
  for (std::size_t i = 0; i + 1 < convolutions_.size(); ++i) {
    Convolve(*in, &convolutions_[i]);
    in = &convolutions_[i].out;
    if (i >= kExplorationPools) continue;
    Pool(*in, &pooled_[i]);
    in = &pooled_[i];
  }
  // The last one's results feed a layer of 16 bits, [rows, cols, channels].
  Convolution& last = convolutions_.back();
  const PictureShape flat = {last.out.shape.rows, last.out.shape.cols, last.out.shape.channels, 0};
  const std::vector<std::int32_t> offsets = PixelOffsets(flat, 1);
  LayerOutput output;
  output.fine = codes_.data();
  output.fine_offsets = offsets.data();
  output.high = kExplorationLargest;
  last.layer.Run({in->bytes.data(), last.in_offsets, in->shape.row_stride()}, {}, output);
  std::fill(codes_.begin() + kExplorationCodes, codes_.end(), std::int16_t{0});
  codes_[kExplorationCodes + static_cast<std::size_t>(heading)] = kExplorationLargest;
  Values features;
  first_.RunOne(codes_.data(), 0, kExplorationLargest, &inside_);
  second_.RunOne(inside_.data(), 0, kExplorationLargest, &features);
  mean_.RunOne(features.data(), -kLargestFine, kLargestFine, &inside_);
  return {{kMeanStep * inside_[0], kMeanStep * inside_[1]}, deviation_};
}

}  // namespace bulletnav::agent
