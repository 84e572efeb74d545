// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/math/rng.h"
#include "sim/sensors/noise/sensor_noise.h"

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

/// Any of the named models of cameras (sim::SensorNoiseNames) but `none`, with panes of glass, at a
/// strength of 0 to `strength`.
sim::SensorNoise DrawSensorNoise(double strength, sim::Rng* rng);

}  // namespace bulletnav::bench
