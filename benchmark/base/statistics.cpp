// SPDX-License-Identifier: MIT
#include "benchmark/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr double kZ = 1.959963984540054;  // normal quantile of 97.5%
constexpr int kResamples = 2000;
constexpr std::size_t kTail = 50;  // resamples in 2.5% of them

/// Probability of at most k heads in n throws of a fair coin.
double BinomialTail(int k, int n) {
  double sum = 0.0;
  double log_choices = 0.0;  // of i heads
  for (int i = 0; i <= k; ++i) {
    sum += sim::Exp(log_choices - n * std::numbers::ln2);
    log_choices += sim::Log((n - i) / (i + 1.0));
  }
  return sum;
}

}  // namespace

double Mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

Interval WilsonInterval(int successes, int count) {
  BULLETNAV_CHECK(successes >= 0 && successes <= count);
  if (count == 0) return {0.0, 1.0};
  const double n = count;
  const double share = successes / n;
  const double shrink = 1.0 / (1.0 + kZ * kZ / n);
  const double centre = shrink * (share + kZ * kZ / (2.0 * n));
  const double half = shrink * kZ * std::sqrt(share * (1.0 - share) / n + kZ * kZ / (4.0 * n * n));
  // Exactly, what rounding would miss by a last digit.
  return {successes == 0 ? 0.0 : centre - half, successes == count ? 1.0 : centre + half};
}

Interval ShareInterval(std::span<const double> values) {
  const auto ones = std::count(values.begin(), values.end(), 1.0);
  return WilsonInterval(static_cast<int>(ones), static_cast<int>(values.size()));
}

Interval BootstrapInterval(std::span<const double> values, std::uint64_t seed) {
  if (values.empty()) return {};
  sim::Rng rng(seed, "bootstrap");
  const auto count = static_cast<int>(values.size());
  std::vector<double> means;
  for (int i = 0; i < kResamples; ++i) {
    double sum = 0.0;
    for (int k = 0; k < count; ++k) sum += values[static_cast<std::size_t>(rng.Below(count))];
    means.push_back(sum / count);
  }
  std::sort(means.begin(), means.end());
  return {means[kTail], means[means.size() - 1 - kTail]};
}

PairedDifference ComparePairs(std::span<const double> a, std::span<const double> b,
                              std::uint64_t seed) {
  BULLETNAV_CHECK_EQ(a.size(), b.size());
  PairedDifference result;
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differences.push_back(b[i] - a[i]);
    result.better += b[i] > a[i] ? 1 : 0;
    result.worse += b[i] < a[i] ? 1 : 0;
  }
  result.pairs = static_cast<int>(a.size());
  result.mean = Mean(differences);
  result.interval = BootstrapInterval(differences, seed);
  const int fewer = std::min(result.better, result.worse);
  result.p_value = std::min(1.0, 2.0 * BinomialTail(fewer, result.better + result.worse));
  return result;
}

}  // namespace bulletnav::bench
