// SPDX-License-Identifier: MIT
#include "sim/sensors/noise/glass_noise.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim {
namespace {

PixelAxis Across(const PixelAngles& angles, bool wraps) {
  const std::size_t cols = angles.across.size();
  return {static_cast<int>(cols), 1.0 / angles.across[cols / 2], wraps};
}

PixelAxis Upwards(const PixelAngles& angles) {
  const std::size_t rows = angles.upwards.size();
  return {static_cast<int>(rows), 1.0 / angles.upwards[rows / 2], false};
}

std::array<std::uint32_t, 2> DrawKey(Rng* rng) {
  const std::uint32_t first = rng->Next();
  return {first, rng->Next()};
}

/// A picture's ranges, whose last column may be followed by the first.
class Surface {
 public:
  Surface(std::span<const float> depth, const PixelAngles& angles, bool wraps)
      : depth_(depth),
        angles_(angles),
        rows_(angles.upwards.size()),
        cols_(angles.across.size()),
        wraps_(wraps) {}

  /// Of the angle between the ray and the surface's normal, from the neighbours that are nearer in
  /// range, as the other noise takes it.
  float CosineAt(std::size_t row, std::size_t col) const {
    const float d = depth_[row * cols_ + col];
    const float left = At(row, col > 0 ? col - 1 : (wraps_ ? cols_ - 1 : 0));
    const float right = At(row, col + 1 < cols_ ? col + 1 : (wraps_ ? 0 : cols_ - 1));
    const float x = std::min(std::abs(d - left), std::abs(right - d));
    const float y = std::min(std::abs(d - At(row > 0 ? row - 1 : 0, col)),
                             std::abs(At(std::min(row + 1, rows_ - 1), col) - d));
    const float rise_x = x / d * angles_.across[col] * angles_.stretch[row];
    const float rise_y = y / d * angles_.upwards[row];
    return 1.0f / std::sqrt(1.0f + (rise_x * rise_x + rise_y * rise_y));
  }

 private:
  float At(std::size_t row, std::size_t col) const { return depth_[row * cols_ + col]; }

  std::span<const float> depth_;
  const PixelAngles& angles_;
  std::size_t rows_;
  std::size_t cols_;
  bool wraps_;
};

}  // namespace

GlassNoise::GlassNoise(const DepthNoise& noise, const PixelAngles& angles, bool wraps)
    : lost_(static_cast<float>(noise.glass_lost)),
      behind_(static_cast<float>(noise.glass_behind)),
      wraps_(wraps),
      holes_(Across(angles, wraps), Upwards(angles)),
      depths_(Across(angles, wraps), Upwards(angles)) {}

void GlassNoise::ReadBehind(Rng rng, std::span<const std::uint8_t> glass, const PixelAngles& angles,
                            std::span<float> depth) {
  losses_.clear();
  readings_.clear();
  const auto is_glass = [](std::uint8_t value) {
    return value != 0;
  };
  auto next = std::find_if(glass.begin(), glass.end(), is_glass);
  if (next == glass.end()) return;
  holes_.Draw(DrawKey(&rng));
  depths_.Draw(DrawKey(&rng));
  const Surface surface(depth, angles, wraps_);
  for (; next != glass.end(); next = std::find_if(next + 1, glass.end(), is_glass)) {
    const auto pixel = static_cast<std::size_t>(next - glass.begin());
    const std::size_t row = pixel / angles.across.size();
    const std::size_t col = pixel % angles.across.size();
    if (depth[pixel] <= 0.0f) continue;
    if (holes_.At(row, col) < 1.0f - (1.0f - lost_) * surface.CosineAt(row, col)) {
      losses_.push_back(pixel);
      continue;
    }
    const float share = depths_.At(row, col);
    if (share < behind_) readings_.push_back({pixel, depth[pixel] * (1.0f + share / behind_)});
  }
  // Now that no neighbour is asked any more.
  for (const Reading& reading : readings_) depth[reading.pixel] = reading.range;
}

void GlassNoise::Lose(std::span<float> depth) const {
  for (const std::size_t pixel : losses_) depth[pixel] = 0.0f;
}

}  // namespace bulletnav::sim
