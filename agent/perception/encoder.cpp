// SPDX-License-Identifier: MIT
#include "agent/perception/encoder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "agent/perception/semantic_model.h"

namespace bulletnav::agent {
namespace {

constexpr int kMapCols = 16;      // of the feature map of a whole panorama
constexpr int kFirstWidth = 256;  // of the first fully connected layer

constexpr double kColorMean = 0.5;
constexpr double kColorDeviation = 0.25;
constexpr double kFarthestDepth = 10.0;  // metres

/// Shares of the map's columns in each patch. Column j sees what is around pixel 32 j of 512.
torch::Tensor PoolingShares() {
  torch::Tensor shares = torch::zeros({kDirections, kMapCols});
  auto share = shares.accessor<float, 2>();
  constexpr double kHalfWidth = kMapCols / 8.0;
  for (int i = 0; i < kDirections; ++i) {
    const double middle = kMapCols * (0.5 - static_cast<double>(i) / kDirections);
    // Also the columns' images one turn to either side.
    for (int j = -kMapCols; j < 2 * kMapCols; ++j) {
      const double low = std::max(j - 0.5, middle - kHalfWidth);
      const double high = std::min(j + 0.5, middle + kHalfWidth);
      const int column = (j + kMapCols) % kMapCols;
      share[i][column] += static_cast<float>(std::max(0.0, high - low) / (2.0 * kHalfWidth));
    }
  }
  return shares;
}

torch::Tensor CropColumns(const ModelConfig& config) {
  const int cols = config.cols();
  std::vector<std::int64_t> columns;
  for (int i = 0; i < kDirections; ++i) {
    const double middle = cols * (0.5 - static_cast<double>(i) / kDirections);
    const int first = static_cast<int>(std::lround(middle)) - config.rows / 2;
    for (int c = 0; c < config.rows; ++c) columns.push_back((first + c + cols) % cols);
  }
  return torch::tensor(columns, torch::kInt64);
}

Trunk::Shape TrunkShape(const ModelConfig& config, int in) {
  const int halvings = config.rows == 128 ? 3 : config.rows == 64 ? 2 : 1;
  const Ends ends = config.encoder == EncoderForm::kPanorama ? Ends::kMeet : Ends::kZeros;
  return {in, config.width, halvings, ends};
}

}  // namespace

Encoder::Encoder(const ModelConfig& config, sim::Rng* rng) : config_(config) {
  const bool separate = config.depth == DepthFusion::kSeparate;
  const int features = 8 * config.width;
  const int channels = config.depth == DepthFusion::kChannel ? 4 : 3;
  trunk_ = register_module("trunk", std::make_shared<Trunk>(TrunkShape(config, channels), rng));
  if (separate) {
    depth_trunk_ =
        register_module("depth_trunk", std::make_shared<Trunk>(TrunkShape(config, 1), rng));
    depth_mixer_ = register_module(
        "depth_mixer", std::make_shared<ConvNorm>(ConvNorm::Shape{features, features, 1}, rng));
  }
  const int pooled = separate ? 2 * features : features;
  first_ = register_module("first", std::make_shared<Dense>(pooled, kFirstWidth, rng));
  second_ = register_module("second", std::make_shared<Dense>(kFirstWidth, kCodeSize, rng));
  // Not buffers: they follow from the configuration and do not belong to the weights.
  if (config.encoder == EncoderForm::kPanorama) {
    pooling_ = PoolingShares();
  } else {
    crop_columns_ = CropColumns(config);
  }
}

torch::Tensor Encoder::Features(const torch::Tensor& pictures) {
  if (!depth_trunk_) return trunk_->forward(pictures);
  const auto part = [&](std::int64_t begin, std::int64_t count) {
    return pictures.narrow(1, begin, count).contiguous(at::MemoryFormat::ChannelsLast);
  };
  const torch::Tensor depth = depth_mixer_->forward(depth_trunk_->forward(part(3, 1))).relu_();
  return at::cat({trunk_->forward(part(0, 3)), depth}, 1);
}

torch::Tensor Encoder::PatchFeatures(const torch::Tensor& input) {
  const std::int64_t count = input.size(0);
  if (config_.encoder == EncoderForm::kPanorama) {
    const torch::Tensor columns = Features(input).to(torch::kFloat32).mean(2);  // [n, f, 16]
    return at::matmul(pooling_.to(input.device()), columns.transpose(1, 2));
  }
  const std::int64_t rows = config_.rows;
  const torch::Tensor patches = input.index_select(3, crop_columns_.to(input.device()))
                                    .view({count, input.size(1), rows, kDirections, rows})
                                    .permute({0, 3, 1, 2, 4})
                                    .reshape({count * kDirections, input.size(1), rows, rows})
                                    .contiguous(at::MemoryFormat::ChannelsLast);
  return Features(patches).to(torch::kFloat32).mean({2, 3}).view({count, kDirections, -1});
}

torch::Tensor Encoder::forward(const torch::Tensor& input, std::optional<at::Generator> dropout) {
  const torch::Tensor features = PatchFeatures(input.to(ComputeType(config_)));
  const torch::Tensor hidden = Dropout(first_->forward(features).relu(), config_.dropout, dropout);
  return Dropout(second_->forward(hidden).relu(), config_.dropout, dropout);
}

void Encoder::Fold(torch::ScalarType type) {
  trunk_->Fold(type);
  if (!depth_trunk_) return;
  depth_trunk_->Fold(type);
  depth_mixer_->Fold(type);
}

torch::Tensor PrepareInput(const ModelConfig& config, const torch::Tensor& color,
                           const torch::Tensor& depth) {
  std::vector<torch::Tensor> channels = {
      color.to(torch::kFloat32).div_(255.0).sub_(kColorMean).div_(kColorDeviation)};
  if (config.uses_depth()) {
    channels.push_back(
        depth.unsqueeze(3).clamp(0.0, kFarthestDepth).mul_(2.0 / kFarthestDepth).sub_(1.0));
  }
  const torch::Tensor pixels = channels.size() == 1 ? channels[0] : at::cat(channels, 3);
  const torch::Tensor pictures = pixels.permute({0, 3, 1, 2});
  const std::int64_t factor = kPanoramaRows / config.rows;
  if (factor == 1) return pictures.contiguous(at::MemoryFormat::ChannelsLast);
  return at::avg_pool2d(pictures, {factor, factor}).contiguous(at::MemoryFormat::ChannelsLast);
}

torch::ScalarType ComputeType(const ModelConfig& config) {
  if (config.precision == Precision::kFloat32) return torch::kFloat32;
#if defined(__x86_64__)
  // oneDNN has no bfloat16 convolution below this; ATen's own is far slower than float32.
  if (!__builtin_cpu_supports("avx512bw")) return torch::kFloat32;
#endif
  return torch::kBFloat16;
}

}  // namespace bulletnav::agent
