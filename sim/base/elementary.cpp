// SPDX-License-Identifier: MIT
#include "sim/base/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bulletnav::sim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// pi / 2 in parts: multiples of the first two up to 2^20 are exact.
constexpr double kHalfPi1 = 0x1.921fb54400000p+0;
constexpr double kHalfPi2 = 0x1.0b4611a600000p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kPerHalfPi = 0x1.45f306dc9c883p-1;
constexpr double kHalfPi = 0x1.921fb54442d18p+0;
constexpr double kHalfPiRest = 0x1.1a62633145c07p-54;

// log 2 likewise.
constexpr double kLog2High = 0x1.62e42fef00000p-1;
constexpr double kLog2Low = 0x1.473de6af278edp-34;
constexpr double kPerLog2 = 0x1.71547652b82fep+0;

/// a[0] + x (a[1] + x (a[2] + ...)).
template <std::size_t N>
constexpr double Polynomial(const std::array<double, N>& a, double x) {
  double sum = a[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + a[i];
  return sum;
}

/// first, -first / ((from + 1)(from + 2)), ...: the signed series of sine and cosine.
template <std::size_t N>
constexpr std::array<double, N> Alternating(double from) {
  std::array<double, N> a{};
  double factorial = 1.0;
  for (double i = 2.0; i <= from; ++i) factorial *= i;
  for (std::size_t k = 0; k < N; ++k) {
    a[k] = (k % 2 == 0 ? 1.0 : -1.0) / factorial;
    factorial *= (from + 1.0) * (from + 2.0);
    from += 2.0;
  }
  return a;
}

/// An angle as quarter turns and what is left, high + low, within an eighth turn.
struct Quarters {
  long count;
  double high;
  double low;
};

Quarters Reduce(double x) {
  if (std::abs(x) > 500000.0) x = std::remainder(x, 4.0 * kHalfPi);
  const double n = std::nearbyint(x * kPerHalfPi);
  const double a = x - n * kHalfPi1;
  const double b = n * kHalfPi2;
  const double high = a - b;
  // What a - b lost, by Knuth's sum of two.
  const double part = high - a;
  const double lost = (a - (high - part)) - (b + part);
  return {static_cast<long>(n), high, lost - n * kHalfPi3};
}

/// Within an eighth turn.
double SinOf(const Quarters& q) {
  static constexpr auto kSeries = Alternating<8>(3.0);  // -x^3 / 3! + ...
  const double square = q.high * q.high;
  const double cube = square * q.high;
  return q.high - (cube * Polynomial(kSeries, square) - q.low * (1.0 - 0.5 * square));
}

double CosOf(const Quarters& q) {
  static constexpr auto kSeries = Alternating<8>(4.0);  // x^4 / 4! - ...
  const double square = q.high * q.high;
  const double half = 0.5 * square;
  const double first = 1.0 - half;
  const double lost = (1.0 - first) - half;
  return first + (lost + (square * square * Polynomial(kSeries, square) - q.high * q.low));
}

/// atan t = atan c + atan((t - c) / (1 + t c)), c in eighths; t in [0, 1].
double AtanOfUpToOne(double t, double sign, double from, double from_rest) {
  static constexpr std::array<double, 9> kEighths = {0.0,
                                                     0x1.fd5ba9aac2f6ep-4,
                                                     0x1.f5b75f92c80ddp-3,
                                                     0x1.6f61941e4def1p-2,
                                                     0x1.dac670561bb4fp-2,
                                                     0x1.1e00babdefeb4p-1,
                                                     0x1.4978fa3269ee1p-1,
                                                     0x1.700a7c5784634p-1,
                                                     0x1.921fb54442d18p-1};
  static constexpr std::array<double, 7> kSeries = {1.0 / 3,  -1.0 / 5,  1.0 / 7, -1.0 / 9,
                                                    1.0 / 11, -1.0 / 13, 1.0 / 15};
  const double index = std::nearbyint(8.0 * t);
  const double c = index / 8.0;
  const double small = (t - c) / (1.0 + t * c);
  const double square = small * small;
  const double rest = small - small * square * Polynomial(kSeries, square);
  return from + sign * (kEighths[static_cast<std::size_t>(index)] + (rest + sign * from_rest));
}

}  // namespace

double Sin(double x) {
  if (!(std::abs(x) < kInfinity)) return kNan;
  if (x == 0.0) return x;
  const Quarters q = Reduce(x);
  const double value = q.count % 2 == 0 ? SinOf(q) : CosOf(q);
  return (q.count & 2) == 0 ? value : -value;
}

double Cos(double x) {
  if (!(std::abs(x) < kInfinity)) return kNan;
  const Quarters q = Reduce(x);
  const double value = q.count % 2 == 0 ? CosOf(q) : SinOf(q);
  return ((q.count + 1) & 2) == 0 ? value : -value;
}

double Tan(double x) {
  if (!(std::abs(x) < kInfinity)) return kNan;
  if (x == 0.0) return x;
  const Quarters q = Reduce(x);
  return q.count % 2 == 0 ? SinOf(q) / CosOf(q) : -CosOf(q) / SinOf(q);
}

double Atan(double x) {
  if (std::isnan(x)) return x;
  const double size = std::abs(x);
  const double angle = size <= 1.0 ? AtanOfUpToOne(size, 1.0, 0.0, 0.0)
                                   : AtanOfUpToOne(1.0 / size, -1.0, kHalfPi, kHalfPiRest);
  return std::copysign(angle, x);
}

double Atan2(double y, double x) {
  if (!(std::abs(x) < kInfinity) || !(std::abs(y) < kInfinity)) return kNan;
  const double across = std::abs(y);
  const double along = std::abs(x);
  double angle = 0.0;
  if (across > along) {
    angle = AtanOfUpToOne(along / across, std::signbit(x) ? 1.0 : -1.0, kHalfPi, kHalfPiRest);
  } else if (std::signbit(x)) {
    const double ratio = along > 0.0 ? across / along : 0.0;
    angle = AtanOfUpToOne(ratio, -1.0, 2.0 * kHalfPi, 2.0 * kHalfPiRest);
  } else {
    angle = along > 0.0 ? AtanOfUpToOne(across / along, 1.0, 0.0, 0.0) : 0.0;
  }
  return std::copysign(angle, y);
}

double Asin(double x) {
  if (!(std::abs(x) <= 1.0)) return kNan;
  return Atan2(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double Acos(double x) {
  if (!(std::abs(x) <= 1.0)) return kNan;
  return Atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double Exp(double x) {
  static constexpr std::array<double, 13> kSeries = [] {
    std::array<double, 13> a{};  // 1 / 2!, 1 / 3!, ...
    double factorial = 1.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      factorial *= static_cast<double>(i + 2);
      a[i] = 1.0 / factorial;
    }
    return a;
  }();
  if (std::isnan(x)) return x;
  if (x > 709.8) return kInfinity;
  if (x < -745.2) return 0.0;
  const double n = std::nearbyint(x * kPerLog2);
  const double high = x - n * kLog2High;
  const double low = n * kLog2Low;
  const double rest = high - low;
  const double lost = (high - rest) - low;
  const double value = 1.0 + (rest + (lost + rest * rest * Polynomial(kSeries, rest)));
  return std::ldexp(value, static_cast<int>(n));
}

double Log(double x) {
  static constexpr std::array<double, 11> kSeries = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,
                                                     2.0 / 11, 2.0 / 13, 2.0 / 15, 2.0 / 17,
                                                     2.0 / 19, 2.0 / 21, 2.0 / 23};
  if (std::isnan(x) || x < 0.0) return kNan;
  if (x == 0.0) return -kInfinity;
  if (x == kInfinity) return x;
  int exponent = 0;
  double part = std::frexp(x, &exponent);  // [1/2, 1)
  if (part < 0x1.6a09e667f3bcdp-1) {       // sqrt(1/2)
    part *= 2.0;
    --exponent;
  }
  // log(1 + f) = f - f^2 / 2 + s (f^2 / 2 + series), s = f / (2 + f).
  const double f = part - 1.0;
  const double s = f / (2.0 + f);
  const double square = s * s;
  const double half = 0.5 * f * f;
  const double n = exponent;
  return n * kLog2High -
         ((half - (s * (half + square * Polynomial(kSeries, square)) + n * kLog2Low)) - f);
}

double Pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (x == 0.0) return y > 0.0 ? 0.0 : kInfinity;
  return Exp(y * Log(x));
}

}  // namespace bulletnav::sim
