// SPDX-License-Identifier: MIT
#include "sim/base/elementary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace bulletnav::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 200000;

/// |a - exact| in units in the last place of the exact value, which has 64 bits.
double Units(double a, long double exact) {
  const double rounded = static_cast<double>(exact);
  if (rounded == 0.0) return a == 0.0 ? 0.0 : kInfinity;
  const double unit = std::nextafter(std::abs(rounded), kInfinity) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(a) - exact)) / unit;
}

template <class F, class G>
double Worst(double low, double high, const F& f, const G& exact) {
  std::mt19937_64 bits(1);
  double worst = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double share = static_cast<double>(bits() >> 11) * 0x1p-53;
    const double x = low + (high - low) * share;
    worst = std::max(worst, Units(f(x), exact(static_cast<long double>(x))));
  }
  return worst;
}

/// Of functions by name: their types choose among the overloads.
double WorstOf(double (*f)(double), long double (*exact)(long double), double low, double high) {
  return Worst(low, high, f, exact);
}

TEST(ElementaryTest, IsNearlyTheExactValue) {
  for (const double reach : {0.01, 0.7, 4.0, 100.0, 400000.0}) {
    EXPECT_LT(WorstOf(Sin, std::sin, -reach, reach), 1.5) << reach;
    EXPECT_LT(WorstOf(Cos, std::cos, -reach, reach), 1.5) << reach;
    EXPECT_LT(WorstOf(Tan, std::tan, -reach, reach), 3.0) << reach;
  }
  for (const double reach : {0.01, 1.0, 30.0, 1e9}) {
    EXPECT_LT(WorstOf(Atan, std::atan, -reach, reach), 3.0) << reach;
    EXPECT_LT(WorstOf(Log, std::log, 0.0, reach), 1.5) << reach;
  }
  EXPECT_LT(WorstOf(Log, std::log, 0.9, 1.1), 1.5);
  EXPECT_LT(WorstOf(Asin, std::asin, -1.0, 1.0), 3.0);
  EXPECT_LT(WorstOf(Acos, std::acos, -1.0, 1.0), 3.0);
  for (const double reach : {0.01, 1.0, 30.0, 700.0}) {
    EXPECT_LT(WorstOf(Exp, std::exp, -reach, reach), 1.5) << reach;
  }
}

TEST(ElementaryTest, PowersKeepTheirRelativeError) {
  for (const double y : {0.4166, 2.4, -3.0, 17.5}) {
    const double worst = Worst(
        1e-3, 50.0,
        [&](double x) {
          return Pow(x, y);
        },
        [&](long double x) {
          return std::pow(x, static_cast<long double>(y));
        });
    EXPECT_LT(worst, 2.0 + std::abs(y) * 8.0) << y;
  }
  EXPECT_EQ(Pow(0.0, 2.4), 0.0);
  EXPECT_EQ(Pow(0.0, 0.0), 1.0);
  EXPECT_EQ(Pow(0.0, -1.0), kInfinity);
  EXPECT_EQ(Pow(1.0, 1e9), 1.0);
  EXPECT_TRUE(std::isnan(Pow(-1.0, 2.0)));
}

TEST(ElementaryTest, Atan2KnowsQuadrantsAndSignedZeros) {
  for (const double y : {-3.0, -1.0, -1e-9, -0.0, 0.0, 1e-9, 1.0, 3.0, 1e300}) {
    for (const double x : {-3.0, -1.0, -1e-9, -0.0, 0.0, 1e-9, 1.0, 3.0, 1e-300}) {
      const double exact = std::atan2(y, x);
      EXPECT_NEAR(Atan2(y, x), exact, 1e-15) << y << ' ' << x;
      EXPECT_EQ(std::signbit(Atan2(y, x)), std::signbit(exact)) << y << ' ' << x;
    }
  }
}

TEST(ElementaryTest, SpecialValues) {
  EXPECT_EQ(Sin(0.0), 0.0);
  EXPECT_TRUE(std::signbit(Sin(-0.0)));
  EXPECT_EQ(Cos(0.0), 1.0);
  EXPECT_EQ(Exp(0.0), 1.0);
  EXPECT_EQ(Log(1.0), 0.0);
  EXPECT_EQ(Asin(1.0), std::asin(1.0));
  EXPECT_EQ(Acos(1.0), 0.0);
  EXPECT_EQ(Log(0.0), -kInfinity);
  EXPECT_EQ(Log(kInfinity), kInfinity);
  EXPECT_EQ(Exp(-kInfinity), 0.0);
  EXPECT_EQ(Exp(kInfinity), kInfinity);
  for (const double x : {kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_TRUE(std::isnan(Sin(x)) && std::isnan(Cos(x)) && std::isnan(Tan(x)));
  }
  EXPECT_TRUE(std::isnan(Asin(1.1)) && std::isnan(Acos(-1.1)) && std::isnan(Log(-1.0)));
  EXPECT_TRUE(std::isnan(Exp(std::nan(""))) && std::isnan(Atan(std::nan(""))));
  EXPECT_EQ(Atan(kInfinity), std::atan(kInfinity));
}

/// What a run's numbers hang on: the bits themselves, those of the C library's functions that are
/// used beside these among them.
TEST(ElementaryTest, BitsAreTheSameEverywhere) {
  std::mt19937_64 bits(1);
  std::uint64_t hash = 0;
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
  };
  for (int i = 0; i < kSamples; ++i) {
    const double x = static_cast<double>(bits() >> 11) * 0x1p-53 * 20.0 - 10.0;
    const double y = static_cast<double>(bits() >> 11) * 0x1p-53 * 20.0 - 10.0;
    add(Sin(x));
    add(Cos(x));
    add(Tan(x));
    add(Atan2(y, x));
    add(Acos(x / 10.0));
    add(Exp(x));
    add(Log(std::abs(x)));
    add(Pow(std::abs(x), y));
    add(std::hypot(x, y));
    add(std::cbrt(x));
    add(std::exp2(x));
    add(std::remainder(x, 3.0));
  }
  EXPECT_EQ(hash, 6773839032873605204u);
}

}  // namespace
}  // namespace bulletnav::sim
