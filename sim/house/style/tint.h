// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::sim::style {

/// A colour as in HTML: Hex(0xFFAA00).
constexpr Rgb8 Hex(unsigned rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>((rgb >> 8) & 255),
          static_cast<std::uint8_t>(rgb & 255)};
}

/// Part `t` of the way from a to b.
Rgb8 Mix(const Rgb8& a, const Rgb8& b, double t);

/// Distance in CIE L*a*b* (1976) of two sRGB colours.
double ColorDistance(const Rgb8& a, const Rgb8& b);

}  // namespace bulletnav::sim::style
