// SPDX-License-Identifier: MIT
#include "sim/image/hue.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim {

std::array<double, 3> FromHue(double hue, double saturation, double value) {
  std::array<double, 3> color{};
  for (std::size_t c = 0; c < color.size(); ++c) {
    constexpr std::array kBegins = {0.0, 4.0, 2.0};
    double place = 6.0 * hue + kBegins[c];
    if (place >= 6.0) place -= 6.0;
    const double part = std::clamp(std::abs(place - 3.0) - 1.0, 0.0, 1.0);
    color[c] = value * (1.0 - saturation + saturation * part);
  }
  return color;
}

}  // namespace bulletnav::sim
