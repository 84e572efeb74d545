// SPDX-License-Identifier: MIT
#include "benchmark/report/palette.h"

#include <algorithm>
#include <cmath>

#include "sim/image/hue.h"

namespace bulletnav::bench {
namespace {

// Viridis at 0, 1/9, ..., 1.
constexpr std::array<std::array<double, 3>, 10> kViridis = {{{68, 1, 84},
                                                             {72, 40, 120},
                                                             {62, 74, 137},
                                                             {49, 104, 142},
                                                             {38, 130, 142},
                                                             {31, 158, 137},
                                                             {53, 183, 121},
                                                             {109, 205, 89},
                                                             {180, 222, 44},
                                                             {253, 231, 37}}};
constexpr double kLightest = 0.93;

}  // namespace

Paint TimeColor(double t) {
  const double at = kLightest * std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const double part = at - static_cast<double>(i);
  const auto mixed = [&](std::size_t channel) {
    return ((1.0 - part) * kViridis[i][channel] + part * kViridis[i + 1][channel]) / 255.0;
  };
  return {mixed(0), mixed(1), mixed(2)};
}

Paint KindColor(int kind) {
  constexpr double kGolden = 0.6180339887498949;  // of a turn
  constexpr std::array<double, 3> kValues = {0.85, 0.5, 1.0};
  constexpr std::array<double, 3> kSaturations = {0.85, 0.8, 0.5};
  const double turned = kind * kGolden;
  const auto look = static_cast<std::size_t>(kind) % kValues.size();
  const auto color = sim::FromHue(turned - std::floor(turned), kSaturations[look], kValues[look]);
  return {color[0], color[1], color[2]};
}

}  // namespace bulletnav::bench
