// SPDX-License-Identifier: MIT
#include "agent/perception/quantise_trunk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agent/integer/integer_trunk.h"
#include "agent/integer/kernels/kernels.h"
#include "agent/perception/layers.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kNormEpsilon = 1e-5;  // as in ConvNorm
constexpr std::int64_t kMostValues = 100'000;
constexpr double kLargestInt = 2147483647.0;
constexpr int kLargest16BitWeight = 32767;

/// Squared error of values rounded to whole steps within [low, high].
double Error(const std::vector<float>& values, double step, double low, double high) {
  double error = 0.0;
  for (const float value : values) {
    const double rounded = std::clamp(std::nearbyint(value / step), low, high) * step;
    error += (value - rounded) * (value - rounded);
  }
  return error;
}

/// Of those that put `most`, or a part of it, at `steps`: the one of the least error.
double BestStep(const std::vector<float>& values, double most, double low, int steps) {
  double best = most / steps;
  double least = Error(values, best, low, steps);
  for (double part = 0.98; part > 0.3; part *= 0.98) {
    const double error = Error(values, part * most / steps, low, steps);
    if (error >= least) continue;
    least = error;
    best = part * most / steps;
  }
  return best;
}

std::vector<float> Values(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.reshape({-1}).to(torch::kFloat32).contiguous();
  const std::int64_t apart = std::max<std::int64_t>(1, flat.numel() / kMostValues);
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(flat.numel() / apart + 1));
  const float* data = flat.data_ptr<float>();
  for (std::int64_t i = 0; i < flat.numel(); i += apart) values.push_back(data[i]);
  return values;
}

float MostOf(const std::vector<float>& values) {
  float most = 1e-6f;  // of layers that are silent: any scale will do
  for (const float value : values) most = std::max(most, std::abs(value));
  return most;
}

/// [out, segments, inputs] and [out] to a layer whose weights lie within `largest`.
QuantisedLayer Rounded(const torch::Tensor& weight, const torch::Tensor& bias, int largest,
                       const std::vector<double>& least_scale) {
  QuantisedLayer layer;
  layer.outputs = static_cast<int>(weight.size(0));
  layer.segments = static_cast<int>(weight.size(1));
  layer.inputs = static_cast<int>(weight.size(2));
  for (std::int64_t o = 0; o < weight.size(0); ++o) {
    const torch::Tensor row = weight.select(0, o).contiguous();
    const std::vector<float> values(row.data_ptr<float>(), row.data_ptr<float>() + row.numel());
    const double most = MostOf(values);
    const double fitted =
        largest > 127 ? most / largest : BestStep(values, most, -largest, largest);
    const auto scale =
        static_cast<float>(std::max(fitted, least_scale[static_cast<std::size_t>(o)]));
    for (const float value : values) {
      layer.weights.push_back(static_cast<std::int16_t>(
          std::clamp<double>(std::nearbyint(value / double{scale}), -largest, largest)));
    }
    layer.scale.push_back(scale);
    layer.bias.push_back(bias[o].item<float>());
  }
  return layer;
}

torch::Tensor ThreeDimensional(const torch::Tensor& weight) {
  return weight.dim() == 3 ? weight : weight.unsqueeze(1);
}

}  // namespace

Quantiser::Quantiser(const torch::nn::Module& net) {
  for (const auto& item : net.named_parameters()) weights_[item.key()] = item.value().detach();
  for (const auto& item : net.named_buffers()) weights_[item.key()] = item.value().detach();
}

const torch::Tensor& Quantiser::Weight(const std::string& name) const {
  const auto found = weights_.find(name);
  if (found == weights_.end()) throw sim::Error("the network has no weights " + name);
  return found->second;
}

double Quantiser::FitScale(const std::string& name, const torch::Tensor& values, int steps) {
  const std::vector<float> some = Values(values);
  const bool is_signed = values.min().item<float>() < 0.0f;
  const double step = BestStep(some, MostOf(some), is_signed ? -steps : 0.0, steps);
  return result_.scales[name] = static_cast<float>(step);
}

double Quantiser::RoomyScale(const std::string& name, const torch::Tensor& values, int steps,
                             double margin) {
  const float most = std::max(1e-6f, values.abs().max().item<float>());
  return result_.scales[name] = static_cast<float>(margin * most / steps);
}

torch::Tensor Quantiser::Convolve(const std::string& name, const torch::Tensor& x,
                                  const Conv& conv) {
  const torch::Tensor factor =
      Weight(name + ".scale") / (Weight(name + ".variance") + kNormEpsilon).sqrt();
  const torch::Tensor weight = Weight(name + ".weight") * factor.view({-1, 1, 1, 1});
  const torch::Tensor bias = Weight(name + ".shift") - Weight(name + ".mean") * factor;
  // [out, rows of the window, columns of it and channels]; the stem's channels filled up.
  torch::Tensor rows = weight.permute({0, 2, 3, 1});
  if (rows.size(3) == 4) {
    // All channels of the input have the colours' scale; depths are half as large.
    rows = rows * torch::tensor({1.0f, 1.0f, 1.0f, 0.5f});
  } else if (rows.size(3) == 3) {
    rows = at::constant_pad_nd(rows, {0, 1});
  }
  rows = rows.reshape({rows.size(0), rows.size(1), -1});
  result_.layers[name] = Rounded(rows, bias, kLargestWeight8,
                                 std::vector<double>(static_cast<std::size_t>(rows.size(0)), 0.0));
  const int pad = conv.kernel / 2;
  return at::conv2d(Widened(x, pad), weight, bias, conv.stride,
                    std::array<std::int64_t, 2>{pad, 0});
}

torch::Tensor Quantiser::Block(const std::string& prefix, const torch::Tensor& x, int stride) {
  torch::Tensor kept = x;
  if (weights_.contains(prefix + "shortcut.weight")) {
    kept = Convolve(prefix + "shortcut", x, {1, stride});
    RoomyScale(prefix + "shortcut", kept, 32767, 2.0);
  }
  const torch::Tensor middle = Convolve(prefix + "first", x, {3, stride}).relu();
  FitScale(prefix + "first", middle, 255);
  const torch::Tensor end = (Convolve(prefix + "second", middle, {3, 1}) + kept).relu();
  FitScale(prefix + "second", end, 255);
  return end;
}

torch::Tensor Quantiser::Widened(const torch::Tensor& x, int count) const {
  if (count == 0) return x;
  return ends_meet_ ? WrapColumns(x, count) : at::constant_pad_nd(x, {count, count});
}

std::vector<torch::Tensor> Quantiser::Trunk(const std::string& prefix, const torch::Tensor& input) {
  const std::int64_t rows = input.size(2);
  ends_meet_ = true;
  return Stages(prefix, input, rows == 128 ? 3 : rows == 64 ? 2 : 1);
}

std::vector<torch::Tensor> Quantiser::FlatTrunk(const std::string& prefix,
                                                const torch::Tensor& input, int halvings) {
  ends_meet_ = false;
  return Stages(prefix, input, halvings);
}

std::vector<torch::Tensor> Quantiser::Stages(const std::string& prefix, const torch::Tensor& input,
                                             int halvings) {
  result_.scales[prefix + "input"] = 4.0f / 254.0f;  // of colours, see PrepareInput
  torch::Tensor x = Convolve(prefix + "stem", input, {7, 2}).relu();
  x = at::max_pool2d(Widened(x, 1), {3, 3}, {2, 2}, {1, 0});
  FitScale(prefix + "stem", x, 255);
  std::vector<torch::Tensor> stages;
  for (int stage = 0; stage < 4; ++stage) {
    const std::string name = prefix + "stage" + std::to_string(stage + 1) + "_";
    x = Block(name + "1_", x, stage > 0 && stage <= halvings ? 2 : 1);
    x = Block(name + "2_", x, 1);
    stages.push_back(x);
  }
  return stages;
}

void Quantiser::Dense8(const std::string& name, torch::Tensor weight) {
  if (!weight.defined()) weight = Weight(name + ".weight");
  result_.layers[name] =
      Rounded(ThreeDimensional(weight), Weight(name + ".bias"), kLargestWeight8,
              std::vector<double>(static_cast<std::size_t>(weight.size(0)), 0.0));
}

void Quantiser::Dense16(const std::string& name, double in_step, int largest,
                        torch::Tensor weight) {
  if (!weight.defined()) weight = Weight(name + ".weight");
  const torch::Tensor rows = ThreeDimensional(weight);
  const torch::Tensor bias = Weight(name + ".bias");
  std::vector<double> least;
  for (std::int64_t o = 0; o < rows.size(0); ++o) {
    const double size = rows.select(0, o).abs().sum().item<double>();
    const double room = std::abs(bias[o].item<double>()) / in_step + size * largest;
    least.push_back(room / (0.9 * kLargestInt));
  }
  result_.layers[name] = Rounded(rows, bias, kLargest16BitWeight, least);
}

}  // namespace bulletnav::agent
