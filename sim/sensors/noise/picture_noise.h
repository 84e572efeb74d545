// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/math/rng.h"
#include "sim/render/projection.h"
#include "sim/sensors/noise/glass_noise.h"
#include "sim/sensors/noise/kernels/noise_kernels.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::sim {

/// Adds a sensor's noise to pictures of one kind of camera; one for each thread.
/// Angles between pixels are those along the picture's middle row and column, and of rows in
/// panoramas as they are. The same bits on every processor.
class PictureNoise {
 public:
  /// Throws Error for a bad camera or noise. `kernels`: for tests; default: the fastest.
  PictureNoise(const SensorNoise& noise, const CameraSpec& camera,
               const NoiseKernels* kernels = nullptr);

  /// Changes one picture: color u8 [rows, cols, 3], depth f32 [rows, cols] metres, 0 = no return;
  /// an empty span: there is none. What is drawn follows from `rng` alone, whatever is there; but
  /// depth is lost on dark surfaces only where there is colour to tell, and on glass where `glass`
  /// tells: u8 [rows, cols], not 0 on glass, as renderers give it. Without noise, nothing changes.
  /// Expects: sizes that fit (checked).
  void Apply(const Rng& rng, std::span<std::uint8_t> color, std::span<float> depth,
             std::span<const std::uint8_t> glass = {});

  /// Whether it makes a difference for depth to know what is glass.
  bool asks_for_glass() const { return noise_.depth.glass_lost > 0.0; }

 private:
  struct Draws;
  bool has_color_noise() const;
  bool has_depth_noise() const;
  void FillAngles(const CameraSpec& camera);
  void AddColorNoise(const Draws& draws, std::span<std::uint8_t> color);
  void AddDepthNoise(const Draws& draws, std::span<const std::uint8_t> color,
                     std::span<const std::uint8_t> glass, std::span<float> depth);
  void RunDepthKernel(const Draws& draws, std::span<const std::uint8_t> color,
                      std::span<float> depth);
  PixelAngles angles() const { return {across_, upwards_, stretch_}; }
  void PadDepth(std::span<const float> depth);
  void LosePanes(Rng rng, std::span<float> depth) const;
  void LosePane(Rng* rng, std::span<float> depth) const;

  SensorNoise noise_;
  const NoiseKernels* kernels_;
  int rows_ = 0;
  int cols_ = 0;
  bool wraps_ = false;
  float max_depth_ = 0.0f;
  int window_ = 1;  // as in DepthNoiseFrame, like those below
  std::vector<float> azimuth_;
  std::vector<float> across_;
  std::vector<float> upwards_;
  std::vector<float> stretch_;
  std::vector<std::uint8_t> clean_color_;
  std::vector<float> clean_depth_;  // padded
  std::vector<std::uint16_t> color_line_;
  std::vector<float> depth_line_;
  std::optional<GlassNoise> glass_;  // if it is asked for
};

}  // namespace bulletnav::sim
