// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

namespace bulletnav::bench {

/// Mean and variance of all numbers so far. Source: Chan, Golub and LeVeque, "Updating formulae and
/// a pairwise algorithm for computing sample variances", 1979.
class RunningMoments {
 public:
  void Add(std::span<const double> numbers) {
    for (const double number : numbers) {
      count += 1.0;
      const double off = number - mean;
      mean += off / count;
      squares += off * (number - mean);
    }
  }
  /// 1 until there are two different numbers.
  double deviation() const {
    const double variance = count < 2.0 ? 0.0 : squares / count;
    return variance > 0.0 ? std::max(std::sqrt(variance), 1e-4) : 1.0;
  }

  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;  // of differences from the mean, summed
};

}  // namespace bulletnav::bench
