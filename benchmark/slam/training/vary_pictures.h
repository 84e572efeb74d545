// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "benchmark/slam/training/place_config.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// Varies pictures of `rows` x `rows * 4 / 3` pixels, u8 [count, rows, cols, 3]: mirrors all or
/// none, so that what they share stays as it is; colours and noise are each picture's own.
/// Expects: whole pictures (checked).
void VaryPictures(const PictureAugmentSpec& spec, const sim::Rng& rng, int rows,
                  std::vector<std::uint8_t>* pictures);

}  // namespace bulletnav::bench
