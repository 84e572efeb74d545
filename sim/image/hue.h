// SPDX-License-Identifier: MIT
#pragma once
#include <array>

namespace bulletnav::sim {

/// Red, green and blue of a hue, a saturation and a value (HSV), in six straight pieces around the
/// circle. Hue in [0, 1), all else in [0, 1].
std::array<double, 3> FromHue(double hue, double saturation, double value);

}  // namespace bulletnav::sim
