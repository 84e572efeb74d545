// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/image/image.h"

namespace bulletnav::sim {

inline constexpr std::uint32_t kMaxImagePixels = 64'000'000;

/// One decoder a format, all to RGBA; they throw ImageError.
Image DecodePng(std::span<const std::uint8_t> bytes);
Image DecodeJpeg(std::span<const std::uint8_t> bytes);
/// BMP and TGA.
Image DecodeWithStb(std::span<const std::uint8_t> bytes);

}  // namespace bulletnav::sim
