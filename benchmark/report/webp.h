// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sim/image/image.h"

namespace bulletnav::bench {

/// One picture of an animation, RGB, and how long it is shown.
struct AnimationFrame {
  sim::Image image;
  int milliseconds = 100;
};

/// An animated WebP, shown over and over. `quality`: of what is lossy, 0 to 100. Expects: one frame
/// at least, all of one size (checked). Throws sim::Error if it cannot be encoded.
std::vector<std::uint8_t> ToAnimatedWebp(std::span<const AnimationFrame> frames, float quality);

}  // namespace bulletnav::bench
