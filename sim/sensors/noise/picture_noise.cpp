// SPDX-License-Identifier: MIT
#include "sim/sensors/noise/picture_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

constexpr double kNearest = 0.5;     // metres to the things whose shadows are seen in full
constexpr int kMaxWindow = 64;       // columns
constexpr double kMeanSize = 0.798;  // of a standard normal: sqrt(2 / pi)
constexpr float kFar = 1e30f;
constexpr float kPaneDepth = 0.25f;  // share of the range by which a pane's depth may differ

double AngleBetween(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Vector3d u = a.cast<double>();
  const Eigen::Vector3d v = b.cast<double>();
  return Atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

/// What is drawn for a picture as a whole.
struct PictureNoise::Draws {
  explicit Draws(Rng rng)
      : color_key{rng.Next(), 0},
        depth_key{},
        stops(0.0),
        red(0.0),
        blue(0.0),
        panes(rng),
        glass(rng) {
    color_key[1] = rng.Next();
    depth_key[0] = rng.Next();
    depth_key[1] = rng.Next();
    stops = rng.Uniform(-1.0, 1.0);
    red = rng.Uniform(-1.0, 1.0);
    blue = rng.Uniform(-1.0, 1.0);
    panes = rng.Fork("panes");
    glass = rng.Fork("glass");
  }
  std::array<std::uint32_t, 2> color_key;
  std::array<std::uint32_t, 2> depth_key;
  double stops;
  double red;
  double blue;
  Rng panes;
  Rng glass;
};

PictureNoise::PictureNoise(const SensorNoise& noise, const CameraSpec& camera,
                           const NoiseKernels* kernels)
    : noise_(noise),
      kernels_(kernels != nullptr ? kernels : SupportedNoiseKernels().front()),
      rows_(SizeOf(camera).rows),
      cols_(SizeOf(camera).cols),
      wraps_(std::holds_alternative<PanoramaSpec>(camera)),
      max_depth_(MaxDepthOf(camera)) {
  noise_.Validate();
  FillAngles(camera);
  if (asks_for_glass()) glass_.emplace(noise_.depth, angles(), wraps_);
}

bool PictureNoise::has_color_noise() const {
  return noise_.color != ColorNoise();
}

bool PictureNoise::has_depth_noise() const {
  return noise_.depth != DepthNoise();
}

void PictureNoise::FillAngles(const CameraSpec& camera) {
  const RayGrid grid(camera);
  const auto rows = static_cast<std::size_t>(rows_);
  const auto cols = static_cast<std::size_t>(cols_);
  double total = 0.0;
  double least = kPi;
  for (std::size_t i = 0; i < cols; ++i) {
    const std::size_t next = wraps_ ? (i + 1) % cols : std::min(i + 1, cols - 1);
    const std::size_t from = next == i ? i - 1 : i;
    const double angle =
        AngleBetween(grid.Direction(rows / 2, from), grid.Direction(rows / 2, next));
    azimuth_.push_back(static_cast<float>(total));
    across_.push_back(static_cast<float>(1.0 / angle));
    total += angle;
    least = std::min(least, angle);
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t from = i + 1 < rows ? i : i - 1;
    upwards_.push_back(static_cast<float>(
        1.0 / AngleBetween(grid.Direction(from, cols / 2), grid.Direction(from + 1, cols / 2))));
    const float z = grid.z[cols / 2];
    stretch_.push_back(std::sqrt(1.0f + grid.y[i] * grid.y[i] / (z * z)));
  }
  const double shadow = noise_.depth.baseline_m / kNearest;
  while (window_ < kMaxWindow && 2 * window_ < cols_ && window_ * least < shadow) window_ *= 2;
  // Beyond the last column of a flat picture, nothing hides anything.
  for (std::size_t i = 0; i <= static_cast<std::size_t>(window_); ++i) {
    azimuth_.push_back(wraps_ ? azimuth_[i] + static_cast<float>(total) : kFar);
  }
}

void PictureNoise::Apply(const Rng& rng, std::span<std::uint8_t> color, std::span<float> depth,
                         std::span<const std::uint8_t> glass) {
  const std::size_t pixels = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_);
  BULLETNAV_CHECK(color.empty() || color.size() == 3 * pixels);
  BULLETNAV_CHECK(depth.empty() || depth.size() == pixels);
  BULLETNAV_CHECK(glass.empty() || glass.size() == pixels);
  const Draws draws(rng);
  // Depth first: it asks the colour before that is noisy.
  if (!depth.empty() && has_depth_noise()) AddDepthNoise(draws, color, glass, depth);
  if (!color.empty() && has_color_noise()) AddColorNoise(draws, color);
}

void PictureNoise::AddColorNoise(const Draws& draws, std::span<std::uint8_t> color) {
  const ColorNoise& noise = noise_.color;
  clean_color_.assign(color.begin(), color.end());
  color_line_.resize(3 * static_cast<std::size_t>(cols_) + 6);
  ColorNoiseFrame frame{};
  frame.rows = rows_;
  frame.cols = cols_;
  frame.wraps = wraps_;
  frame.in = clean_color_.data();
  frame.out = color.data();
  frame.line = color_line_.data();
  // Shares w, 1 - 2w, w have the variance 2w.
  frame.blur = static_cast<std::uint32_t>(std::lround(128.0 * noise.blur_px * noise.blur_px));
  const auto display = [](double light) {
    return static_cast<float>(std::sqrt(light));
  };
  frame.exposure = display(std::exp2(noise.exposure_stops * draws.stops));
  if (noise.electrons > 0.0) {
    const double read = noise.read_electrons / noise.electrons;
    frame.shot = static_cast<float>(1.0 / noise.electrons);
    frame.read_squared = static_cast<float>(read * read);
  }
  frame.balance[0] = display(1.0 + noise.white_balance * draws.red);
  frame.balance[1] = 1.0f;
  frame.balance[2] = display(1.0 + noise.white_balance * draws.blue);
  std::copy(draws.color_key.begin(), draws.color_key.end(), frame.key);
  kernels_->color(frame);
}

void PictureNoise::PadDepth(std::span<const float> depth) {
  const auto cols = static_cast<std::size_t>(cols_);
  const std::size_t stride = cols + 2;
  clean_depth_.resize(static_cast<std::size_t>(rows_) * stride);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
    const float* from = depth.data() + row * cols;
    float* to = clean_depth_.data() + row * stride;
    std::copy(from, from + cols, to + 1);
    to[0] = wraps_ ? from[cols - 1] : from[0];
    to[cols + 1] = wraps_ ? from[0] : from[cols - 1];
  }
}

void PictureNoise::AddDepthNoise(const Draws& draws, std::span<const std::uint8_t> color,
                                 std::span<const std::uint8_t> glass, std::span<float> depth) {
  const bool has_glass = glass_ && !glass.empty();
  if (has_glass) glass_->ReadBehind(draws.glass, glass, angles(), depth);
  RunDepthKernel(draws, color, depth);
  if (has_glass) glass_->Lose(depth);
  LosePanes(draws.panes, depth);
}

void PictureNoise::RunDepthKernel(const Draws& draws, std::span<const std::uint8_t> color,
                                  std::span<float> depth) {
  const DepthNoise& noise = noise_.depth;
  PadDepth(depth);
  depth_line_.resize(4 * azimuth_.size());
  DepthNoiseFrame frame{};
  frame.rows = rows_;
  frame.cols = cols_;
  frame.stride = cols_ + 2;
  frame.window = window_;
  frame.depth = clean_depth_.data();
  frame.color = color.empty() ? nullptr : color.data();
  frame.out = depth.data();
  frame.line = depth_line_.data();
  frame.azimuth = azimuth_.data();
  frame.across = across_.data();
  frame.upwards = upwards_.data();
  frame.stretch = stretch_.data();
  frame.axial = static_cast<float>(noise.axial_m);
  frame.axial_per_m2 = static_cast<float>(noise.axial_per_m2);
  frame.axial_from = static_cast<float>(noise.axial_from_m);
  frame.grazing = static_cast<float>(noise.grazing_m);
  frame.disparity = static_cast<float>(noise.disparity_m);
  frame.lateral = static_cast<float>(kMeanSize * noise.lateral_rad);
  frame.baseline = static_cast<float>(noise.baseline_m);
  frame.min_range = static_cast<float>(noise.min_range_m);
  frame.max_range = noise.max_range_m > 0.0 ? static_cast<float>(noise.max_range_m) : kFar;
  frame.clip = max_depth_;
  frame.min_cos =
      noise.max_angle_deg < 90.0 ? static_cast<float>(Cos(DegToRad(noise.max_angle_deg))) : 0.0f;
  frame.min_signal = static_cast<float>(noise.min_signal);
  std::copy(draws.depth_key.begin(), draws.depth_key.end(), frame.key);
  kernels_->depth(frame);
}

void PictureNoise::LosePanes(Rng rng, std::span<float> depth) const {
  const double expected = noise_.depth.panes;
  const int panes = static_cast<int>(std::floor(expected + rng.Uniform()));
  for (int i = 0; i < panes; ++i) LosePane(&rng, depth);
}

/// Half a metre to two metres across and high.
void PictureNoise::LosePane(Rng* rng, std::span<float> depth) const {
  const int row = rng->Below(rows_);
  const int col = rng->Below(cols_);
  const double width = rng->Uniform(0.5, 2.0);
  const double height = rng->Uniform(0.5, 2.0);
  const float middle = depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) +
                             static_cast<std::size_t>(col)];
  if (middle <= 0.0f) return;
  const auto half = [&](double size, float per_radian, int most) {
    return std::min(most / 2, static_cast<int>(size / 2.0 / double{middle} * double{per_radian}));
  };
  const int half_cols = half(width, across_[static_cast<std::size_t>(col)], cols_);
  const int half_rows = half(height, upwards_[static_cast<std::size_t>(row)], rows_);
  for (int r = std::max(0, row - half_rows); r <= std::min(rows_ - 1, row + half_rows); ++r) {
    for (int c = col - half_cols; c <= col + half_cols; ++c) {
      if (!wraps_ && (c < 0 || c >= cols_)) continue;
      float& d = depth[static_cast<std::size_t>(r) * static_cast<std::size_t>(cols_) +
                       static_cast<std::size_t>((c + cols_) % cols_)];
      if (std::abs(d - middle) < kPaneDepth * middle) d = 0.0f;
    }
  }
}

}  // namespace bulletnav::sim
