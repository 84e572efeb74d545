// SPDX-License-Identifier: MIT
#include "benchmark/base/statistics.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

TEST(WilsonInterval, KnownValues) {
  // By the formula, worked out apart; 0.0 and 1.0 are exact.
  const Interval half = WilsonInterval(50, 100);
  EXPECT_NEAR(half.low, 0.4038315, 1e-6);
  EXPECT_NEAR(half.high, 0.5961685, 1e-6);
  const Interval none = WilsonInterval(0, 10);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.2775328, 1e-6);
  const Interval all = WilsonInterval(10, 10);
  EXPECT_NEAR(all.low, 0.7224672, 1e-6);
  EXPECT_EQ(all.high, 1.0);
  EXPECT_EQ(WilsonInterval(0, 0), (Interval{0.0, 1.0}));
}

TEST(WilsonInterval, HoldsTheTrueShareAboutNineteenTimesOfTwenty) {
  sim::Rng rng(3, "wilson");
  int held = 0;
  constexpr int kTrials = 4000;
  for (int t = 0; t < kTrials; ++t) {
    int successes = 0;
    for (int i = 0; i < 60; ++i) successes += rng.Chance(0.3) ? 1 : 0;
    const Interval interval = WilsonInterval(successes, 60);
    held += interval.low <= 0.3 && 0.3 <= interval.high ? 1 : 0;
  }
  EXPECT_NEAR(held / static_cast<double>(kTrials), 0.95, 0.02);
}

TEST(BootstrapInterval, IsTheSameForTheSameSeed) {
  const std::vector<double> values = {0.1, 0.9, 0.4, 0.0, 1.0, 0.7};
  EXPECT_EQ(BootstrapInterval(values, 1), BootstrapInterval(values, 1));
  EXPECT_NE(BootstrapInterval(values, 1), BootstrapInterval(values, 2));
}

TEST(BootstrapInterval, AgreesWithTheNormalOneOnManyValues) {
  sim::Rng rng(3, "values");
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(rng.Normal());
  const Interval interval = BootstrapInterval(values, 7);
  EXPECT_NEAR(interval.low, Mean(values) - 1.96 / std::sqrt(1000.0), 0.01);
  EXPECT_NEAR(interval.high, Mean(values) + 1.96 / std::sqrt(1000.0), 0.01);
}

TEST(BootstrapInterval, OfEqualOrNoValuesIsAPoint) {
  EXPECT_EQ(BootstrapInterval(std::vector<double>(5, 0.25), 1), (Interval{0.25, 0.25}));
  EXPECT_EQ(BootstrapInterval({}, 1), (Interval{0.0, 0.0}));
}

TEST(ComparePairs, SeesASmallSteadyDifferenceInNoisyValues) {
  sim::Rng rng(3, "pairs");
  std::vector<double> a;
  std::vector<double> b;
  for (int i = 0; i < 200; ++i) {
    a.push_back(rng.Normal());
    b.push_back(a.back() + 0.05 + 0.1 * rng.Normal());
  }
  const PairedDifference difference = ComparePairs(a, b, 1);
  EXPECT_EQ(difference.pairs, 200);
  EXPECT_NEAR(difference.mean, 0.05, 0.02);
  EXPECT_TRUE(difference.significant());
  EXPECT_FALSE(ComparePairs(a, a, 1).significant());
}

TEST(ComparePairs, SignTestByHand) {
  // 1 worse of 9 that differ: 2 (1 + 9) / 2^9.
  const std::vector<double> a = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1};
  const std::vector<double> b = {1, 1, 1, 1, 1, 1, 1, 1, 0, 1};
  const PairedDifference difference = ComparePairs(a, b, 1);
  EXPECT_EQ(difference.better, 8);
  EXPECT_EQ(difference.worse, 1);
  EXPECT_NEAR(difference.mean, 0.7, 1e-12);
  EXPECT_NEAR(difference.p_value, 20.0 / 512.0, 1e-12);
  EXPECT_EQ(ComparePairs(a, a, 1).p_value, 1.0);
  EXPECT_EQ(ComparePairs({}, {}, 1).pairs, 0);
}

}  // namespace
}  // namespace bulletnav::bench
