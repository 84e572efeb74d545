// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/math/rng.h"
#include "sim/render/projection.h"

namespace bulletnav::bench {

/// How widely the colours of pictures are varied while training.
struct ColorJitter {
  double brightness = 0.0;  // all channels times 1 - this to 1 + this
  double contrast = 0.0;    // as above, around middle grey
  double tint = 0.0;        // as above, each channel by itself

  bool is_none() const { return brightness == 0.0 && contrast == 0.0 && tint == 0.0; }
  /// Throws Error unless all lie in [0, 1).
  void Validate() const;
};

/// Varies the colours of a picture, u8 [pixels, 3]; draws nothing if there is nothing to vary.
void Recolor(const ColorJitter& jitter, sim::Rng* rng, std::span<std::uint8_t> color);

/// Gives a picture, with the probability `share`, the noise of any of the named models of cameras
/// (sim::SensorNoiseNames) but `none`, with panes of glass, at a strength of 0 to `strength`. As
/// sim::PictureNoise::Apply; `depth` may be empty.
void AddSensorNoise(double share, double strength, const sim::CameraSpec& camera, sim::Rng rng,
                    std::span<std::uint8_t> color, std::span<float> depth);
/// Throws KeyError at `sensor_noise` or `noise_strength` unless they are in [0, 1] and (0, 4].
void RequireSensorNoise(double share, double strength);

}  // namespace bulletnav::bench
