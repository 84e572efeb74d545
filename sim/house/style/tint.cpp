// SPDX-License-Identifier: MIT
#include "sim/house/style/tint.h"

#include <cmath>

#include "sim/base/elementary.h"

namespace bulletnav::sim::style {
namespace {

double ToLinear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : Pow((v + 0.055) / 1.055, 2.4);
}

double Root(double t) {
  return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
}

struct Lab {
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
};

Lab ToLab(const Rgb8& rgb) {
  const double r = ToLinear(rgb[0]);
  const double g = ToLinear(rgb[1]);
  const double b = ToLinear(rgb[2]);
  // sRGB primaries, white point D65.
  const double x = Root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = Root(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = Root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

}  // namespace

Rgb8 Mix(const Rgb8& a, const Rgb8& b, double t) {
  Rgb8 mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    mixed[i] = static_cast<std::uint8_t>(std::lround((1.0 - t) * a[i] + t * b[i]));
  }
  return mixed;
}

double ColorDistance(const Rgb8& a, const Rgb8& b) {
  const Lab p = ToLab(a);
  const Lab q = ToLab(b);
  return std::sqrt((p.l - q.l) * (p.l - q.l) + (p.a - q.a) * (p.a - q.a) +
                   (p.b - q.b) * (p.b - q.b));
}

}  // namespace bulletnav::sim::style
