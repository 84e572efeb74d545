// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

namespace bulletnav::bench {

/// A 95% confidence interval.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  bool operator==(const Interval&) const = default;
};

/// 0 for no values.
double Mean(std::span<const double> values);

/// Of a share, from `successes` of `count` trials; [0, 1] for none. Keeps to [0, 1] and is right
/// for shares near them. Source: Wilson, "Probable inference, the law of succession, and
/// statistical inference", 1927.
Interval WilsonInterval(int successes, int count);

/// The same of a share given as ones and zeros.
Interval ShareInterval(std::span<const double> values);

/// Of a mean, by the percentiles of 2000 means of values drawn again with replacement. The same
/// values in the same order and the same seed give the same interval. Source: Efron, 1979.
Interval BootstrapInterval(std::span<const double> values, std::uint64_t seed);

/// How much better b is than a on the same episodes, value for value.
struct PairedDifference {
  int pairs = 0;
  int better = 0;  // pairs in which b is larger
  int worse = 0;
  double mean = 0.0;     // of b - a
  Interval interval;     // of the mean, bootstrapped over pairs
  double p_value = 1.0;  // of the sign test: better and worse as different as this by chance

  /// Whether the interval leaves out zero.
  bool significant() const { return interval.low > 0.0 || interval.high < 0.0; }
};

/// Expects: as many values of one as of the other (checked).
PairedDifference ComparePairs(std::span<const double> a, std::span<const double> b,
                              std::uint64_t seed);

}  // namespace bulletnav::bench
