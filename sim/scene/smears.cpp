// SPDX-License-Identifier: MIT
#include "sim/scene/smears.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/base/elementary.h"
#include "sim/math/rng.h"
#include "sim/scene/patches.h"
#include "sim/scene/smooth_noise.h"

namespace bulletnav::sim {
namespace {

constexpr int kTaps = 12;
constexpr int kMaskCells = 48;      // to a texture's side
constexpr double kPatches = 4.0;    // to a texture's side
constexpr double kPatchSize = 0.8;  // metres, of vertices' colours

/// Where a texture is smeared: a noise, between the corners of a grid.
class Mask {
 public:
  Mask(double share, std::uint64_t seed) {
    const SmoothNoise noise(seed, 1.0 / kPatches);
    for (int y = 0; y < kMaskCells; ++y) {
      for (int x = 0; x < kMaskCells; ++x) {
        const Eigen::Vector3f at(static_cast<float>(x), static_cast<float>(y), 0.0f);
        values_.push_back(noise.RoughAt(at / kMaskCells));
      }
    }
    const std::vector<double> weights(values_.size(), 1.0);
    threshold_ = ThresholdOf(values_, weights, share);
  }

  bool Has(int x, int y, const Image& image) const {
    const std::size_t column = CellOf(x, image.width);
    const std::size_t row = CellOf(y, image.height);
    return values_[row * kMaskCells + column] > threshold_;
  }

 private:
  static std::size_t CellOf(int pixel, int size) {
    return static_cast<std::size_t>(std::int64_t{pixel} * kMaskCells / size);
  }

  std::vector<float> values_;
  float threshold_ = 0.0f;
};

/// Steps from a pixel to those whose mean it gets.
std::vector<std::array<int, 2>> StepsAlong(double turn, double length, const Image& image) {
  std::vector<std::array<int, 2>> steps;
  for (int i = 0; i < kTaps; ++i) {
    const double part = (static_cast<double>(i) / (kTaps - 1) - 0.5) * length;
    steps.push_back({static_cast<int>(std::lround(part * Cos(turn) * image.width)),
                     static_cast<int>(std::lround(part * Sin(turn) * image.height))});
  }
  return steps;
}

int Wrapped(int pixel, int size) {
  const int rest = pixel % size;
  return rest < 0 ? rest + size : rest;
}

/// Mean of the pixels at some steps from one.
Rgb8 MeanAlong(const Image& image, int x, int y, const std::vector<std::array<int, 2>>& steps) {
  std::array<int, 3> sums{};
  for (const auto& [dx, dy] : steps) {
    const std::uint8_t* pixel =
        image.at(Wrapped(x + dx, image.width), Wrapped(y + dy, image.height));
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += pixel[c];
  }
  Rgb8 mean{};
  for (std::size_t c = 0; c < mean.size(); ++c) {
    mean[c] = static_cast<std::uint8_t>((sums[c] + kTaps / 2) / kTaps);
  }
  return mean;
}

Image Smeared(const Image& image, const Mask& mask, const std::vector<std::array<int, 2>>& steps) {
  Image smeared = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!mask.Has(x, y, image)) continue;
      const Rgb8 mean = MeanAlong(image, x, y, steps);
      std::copy(mean.begin(), mean.end(), smeared.at(x, y));
    }
  }
  return smeared;
}

void WashOut(double share, std::uint64_t seed, SceneMesh* mesh) {
  const SmoothNoise noise(seed, kPatchSize);
  std::vector<float> values;
  std::array<std::int64_t, 3> sums{};
  for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
    values.push_back(noise.RoughAt(mesh->positions[v]));
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += mesh->colors[v][c];
  }
  const std::vector<double> weights(values.size(), 1.0);
  const float threshold = ThresholdOf(values, weights, share);
  const auto count = static_cast<std::int64_t>(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (values[v] <= threshold) continue;
    for (std::size_t c = 0; c < sums.size(); ++c) {
      std::uint8_t& value = mesh->colors[v][c];
      value = static_cast<std::uint8_t>((value + 2 * (sums[c] / count)) / 3);
    }
  }
}

}  // namespace

void SmearColors(const Smears& smears, std::uint64_t seed, SceneMesh* mesh) {
  if (smears.share <= 0.0) return;
  const Rng rng(seed, "smears");
  for (std::size_t i = 0; i < mesh->textures.size(); ++i) {
    Image& image = mesh->textures[i].image;
    const double turn = rng.Fork("turn", i).Uniform(0.0, std::numbers::pi);
    const Mask mask(smears.share, MixSeed(seed, i));
    image = Smeared(image, mask, StepsAlong(turn, smears.length, image));
  }
  WashOut(smears.share, seed, mesh);
}

}  // namespace bulletnav::sim
