// SPDX-License-Identifier: MIT
#include "sim/sensors/noise/pixel_patches.h"

#include <algorithm>
#include <cmath>

#include "sim/sensors/noise/kernels/pixel_random.h"

namespace bulletnav::sim {
namespace {

// From node to node. The squares of the octaves' weights add up to 1.
constexpr double kLarge = 0.16;  // radians
constexpr double kSmall = 0.04;
constexpr float kWeightOfLarge = 0.9f;
constexpr float kWeightOfSmall = 0.43588989f;

/// Share of a standard normal below x, within 0.0003. Source: Abramowitz and Stegun, 26.2.18.
float ShareBelow(float x) {
  const float a = std::abs(x);
  const float sum = 1.0f + a * (0.196854f + a * (0.115194f + a * (0.000344f + a * 0.019527f)));
  const float square = sum * sum;
  const float beyond = 0.5f / (square * square);
  return x < 0.0f ? beyond : 1.0f - beyond;
}

}  // namespace

PixelPatches::PixelPatches(const PixelAxis& across, const PixelAxis& upwards) {
  octaves_[0] = {SideOf(across, kLarge), SideOf(upwards, kLarge), kWeightOfLarge, {}};
  octaves_[1] = {SideOf(across, kSmall), SideOf(upwards, kSmall), kWeightOfSmall, {}};
}

PixelPatches::Side PixelPatches::SideOf(const PixelAxis& axis, double size_rad) {
  Side side;
  const double size = std::max(1.0, size_rad / axis.pixel_rad);  // pixels
  const double cells = std::max(1.0, std::round(axis.pixels / size));
  const double step = axis.wraps ? axis.pixels / cells : size;
  side.nodes = static_cast<std::uint32_t>(axis.wraps ? cells : std::ceil(axis.pixels / size) + 1.0);
  for (int i = 0; i < axis.pixels; ++i) {
    const double at = (i + 0.5) / step;
    const double before = std::floor(at);
    const double share = at - before;
    const double norm = std::sqrt(share * share + (1.0 - share) * (1.0 - share));
    const auto node = static_cast<std::uint32_t>(before);
    side.places.push_back({node, (node + 1) % side.nodes, static_cast<float>((1.0 - share) / norm),
                           static_cast<float>(share / norm)});
  }
  return side;
}

void PixelPatches::Draw(const std::array<std::uint32_t, 2>& key) {
  std::uint32_t number = 0;
  for (Octave& octave : octaves_) {
    octave.normals.resize(std::size_t{octave.upwards.nodes} * octave.across.nodes);
    for (float& normal : octave.normals) normal = PixelNormal(PixelBits(number++, key.data()));
  }
}

float PixelPatches::Octave::At(std::size_t row, std::size_t col) const {
  const Place& y = upwards.places[row];
  const Place& x = across.places[col];
  const float* above = &normals[std::size_t{y.before} * across.nodes];
  const float* below = &normals[std::size_t{y.after} * across.nodes];
  const float left = y.weight_before * above[x.before] + y.weight_after * below[x.before];
  const float right = y.weight_before * above[x.after] + y.weight_after * below[x.after];
  return x.weight_before * left + x.weight_after * right;
}

float PixelPatches::At(std::size_t row, std::size_t col) const {
  float normal = 0.0f;
  for (const Octave& octave : octaves_) normal += octave.weight * octave.At(row, col);
  return ShareBelow(normal);
}

}  // namespace bulletnav::sim
