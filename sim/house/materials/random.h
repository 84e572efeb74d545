// SPDX-License-Identifier: MIT
#pragma once
#include <iterator>

#include "sim/house/materials/color.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::materials {

// Arguments of one call are evaluated in any order: let no call take two numbers from one
// generator, or pictures will depend on the compiler. Braces are evaluated from left to right.

/// Uniform in [low, high).
inline float Between(Rng& rng, float low, float high) {
  return static_cast<float>(rng.Uniform(low, high));
}
/// A place in the picture.
inline Point Anywhere(Rng& rng) {
  const float x = Between(rng, 0.0f, 1.0f);
  return {x, Between(rng, 0.0f, 1.0f)};
}
template <class Array>
const auto& OneOf(Rng& rng, const Array& items) {
  return items[static_cast<std::size_t>(rng.Below(static_cast<int>(std::size(items))))];
}

}  // namespace bulletnav::sim::materials
