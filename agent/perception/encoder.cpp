// SPDX-License-Identifier: MIT
#include "agent/perception/encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "agent/models/semantic_model.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kMapCols = 16;      // of the feature map of a whole panorama
constexpr int kFirstWidth = 256;  // of the first fully connected layer

constexpr float kColorMean = 0.5f;
constexpr float kColorDeviation = 0.25f;
constexpr float kFarthestDepth = 10.0f;  // metres

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

/// Means over squares of `factor` pixels of the rows that begin at `in`; red, green and blue of
/// each go to `out`, `stride` numbers apart.
void AverageColor(const std::uint8_t* in, std::int64_t factor, std::int64_t stride, float* out) {
  const float scale = 1.0f / (255.0f * kColorDeviation * static_cast<float>(factor * factor));
  for (std::int64_t col = 0; col < kPanoramaCols / factor; ++col) {
    std::array<int, 3> sum{};
    for (std::int64_t i = 0; i < factor * factor; ++i) {
      const std::uint8_t* pixel =
          in + 3 * ((i / factor) * kPanoramaCols + col * factor + i % factor);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      out[col * stride + static_cast<std::int64_t>(c)] =
          static_cast<float>(sum[c]) * scale - kColorMean / kColorDeviation;
    }
  }
}

/// The same, into the last of four channels.
void AverageDepth(const float* in, std::int64_t factor, float* out) {
  const float scale = 2.0f / (kFarthestDepth * static_cast<float>(factor * factor));
  for (std::int64_t col = 0; col < kPanoramaCols / factor; ++col) {
    float sum = 0.0f;
    for (std::int64_t i = 0; i < factor * factor; ++i) {
      const float metres = in[(i / factor) * kPanoramaCols + col * factor + i % factor];
      sum += metres > kFarthestDepth ? kFarthestDepth : metres;  // keeps what is no number
    }
    out[4 * col] = sum * scale - 1.0f;
  }
}

}  // namespace

Trunk::Shape TrunkShape(const ModelConfig& config, int in) {
  const int halvings = config.rows == 128 ? 3 : config.rows == 64 ? 2 : 1;
  const Ends ends = config.encoder == EncoderForm::kPanorama ? Ends::kMeet : Ends::kZeros;
  return {in, config.width, halvings, ends, config.norm};
}

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
  const std::int64_t factor = kPanoramaRows / config.rows;
  const std::int64_t channels = config.depth == DepthFusion::kNone ? 3 : 4;
  const std::int64_t pictures = color.size(0);
  const torch::Tensor pixels =
      torch::empty({pictures, config.rows, config.cols(), channels}, torch::kFloat32);
  const torch::Tensor colors = color.contiguous();
  const torch::Tensor depths = config.uses_depth() ? depth.contiguous() : depth;
  const std::int64_t rows = pictures * config.rows;  // of all pictures, one below the other
  for (std::int64_t row = 0; row < rows; ++row) {
    float* out = pixels.data_ptr<float>() + row * config.cols() * channels;
    const std::int64_t first = row * factor * kPanoramaCols;
    AverageColor(colors.data_ptr<std::uint8_t>() + 3 * first, factor, channels, out);
    if (config.uses_depth()) AverageDepth(depths.data_ptr<float>() + first, factor, out + 3);
  }
  return pixels.permute({0, 3, 1, 2});
}

torch::Tensor PrepareInput(const ModelConfig& config, const Panorama& panorama) {
  constexpr std::size_t kPixels = std::size_t{kPanoramaRows} * kPanoramaCols;
  BULLETNAV_CHECK_EQ(panorama.color.size(), 3 * kPixels);
  // Torch has no tensors of constants; these are only read.
  const torch::Tensor color = torch::from_blob(const_cast<std::uint8_t*>(panorama.color.data()),
                                               {1, kPanoramaRows, kPanoramaCols, 3}, torch::kUInt8);
  torch::Tensor depth;
  if (config.uses_depth()) {
    BULLETNAV_CHECK_EQ(panorama.depth.size(), kPixels);
    depth = torch::from_blob(const_cast<float*>(panorama.depth.data()),
                             {1, kPanoramaRows, kPanoramaCols}, torch::kFloat32);
  }
  return PrepareInput(config, color, depth);
}

torch::ScalarType ComputeType(const ModelConfig& config) {
  if (config.precision == Precision::kFloat32) return torch::kFloat32;
#if defined(__x86_64__)
  // Without its instructions oneDNN converts, and learns in bfloat16 at a third of float32's speed.
  if (!__builtin_cpu_supports("avx512bf16")) return torch::kFloat32;
#endif
  return torch::kBFloat16;
}

}  // namespace bulletnav::agent
