// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/math/rng.h"
#include "sim/sensors/noise/pixel_patches.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::sim {

/// One over the angles between pixels: [cols] in the middle row, [rows], and [rows] the factor of
/// the first in each row.
struct PixelAngles {
  std::span<const float> across;
  std::span<const float> upwards;
  std::span<const float> stretch;
};

/// What glass and mirrors make of depth, before and after a camera's other noise; see DepthNoise.
/// Cost: some tens of nanoseconds for each pixel of glass, nothing without any.
class GlassNoise {
 public:
  /// `wraps`: the first column follows the last.
  GlassNoise(const DepthNoise& noise, const PixelAngles& angles, bool wraps);

  /// Draws what each pixel of glass gives, and lengthens what is read from behind. `glass` [rows,
  /// cols]: not 0 on glass; `depth` [rows, cols] as drawn, without noise.
  void ReadBehind(Rng rng, std::span<const std::uint8_t> glass, const PixelAngles& angles,
                  std::span<float> depth);
  /// Takes out, from noisy depth, what ReadBehind has drawn to be lost.
  void Lose(std::span<float> depth) const;

 private:
  struct Reading {
    std::size_t pixel = 0;
    float range = 0.0f;
  };

  float lost_;
  float behind_;
  bool wraps_;
  PixelPatches holes_;
  PixelPatches depths_;
  std::vector<std::size_t> losses_;
  std::vector<Reading> readings_;
};

}  // namespace bulletnav::sim
