// SPDX-License-Identifier: MIT
#include "sim/math/rng.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

using Block = std::array<std::uint32_t, 4>;

/// Known answers that the authors of Random123 publish with it (kat_vectors, philox4x32 10 rounds).
TEST(Rng, PhiloxGivesThePublishedBlocks) {
  EXPECT_EQ(Philox4x32({0, 0, 0, 0}, {0, 0}),
            (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(Philox4x32({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Rng, AKeyAlwaysGivesTheSameNumbers) {
  const RngKey key{1, 2, 3, 4, Stream::kOdometry};
  Rng a(key);
  Rng b(key);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.Next(), b.Next());
}

TEST(Rng, EveryPartOfTheKeyMatters) {
  const RngKey base{1, 2, 3, 4, Stream::kOdometry};
  std::set<std::uint32_t> firsts = {Rng(base).Next()};
  RngKey other = base;
  other.run_seed = 9;
  firsts.insert(Rng(other).Next());
  other = base;
  other.scene = 9;
  firsts.insert(Rng(other).Next());
  other = base;
  other.episode = 9;
  firsts.insert(Rng(other).Next());
  other = base;
  other.step = 9;
  firsts.insert(Rng(other).Next());
  other = base;
  other.stream = Stream::kActuation;
  firsts.insert(Rng(other).Next());
  EXPECT_EQ(firsts.size(), 6u);
}

TEST(Rng, ForksAreIndependentAndDoNotMoveTheirParent) {
  Rng parent(5, "house");
  Rng copy = parent;
  Rng sofa = parent.Fork("sofa");
  Rng lamp = parent.Fork("lamp");
  Rng second_sofa = parent.Fork("sofa", 1);
  EXPECT_EQ(parent.Next(), copy.Next());
  const std::set<std::uint32_t> firsts = {sofa.Next(), lamp.Next(), second_sofa.Next()};
  EXPECT_EQ(firsts.size(), 3u);
}

TEST(Rng, UniformFillsTheUnitIntervalEvenly) {
  Rng rng(1, "uniform");
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = rng.Uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.004);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.004);
}

TEST(Rng, NormalHasTheMomentsOfANormal) {
  Rng rng(1, "normal");
  double sum = 0.0;
  double squares = 0.0;
  double fourth = 0.0;
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = rng.Normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.015);
  EXPECT_NEAR(fourth / kDraws, 3.0, 0.1);
}

TEST(Rng, BelowAndBetweenAreFairAndStayInside) {
  Rng rng(1, "below");
  std::array<int, 7> counts{};
  for (int i = 0; i < 70'000; ++i) ++counts[static_cast<std::size_t>(rng.Below(7))];
  for (const int n : counts) EXPECT_NEAR(n, 10'000, 400);
  for (int i = 0; i < 100; ++i) {
    const int x = rng.Between(-2, 2);
    EXPECT_GE(x, -2);
    EXPECT_LE(x, 2);
  }
  EXPECT_EQ(rng.Below(1), 0);
}

TEST(Rng, WeightedPicksInProportionAndNeverWhatWeighsNothing) {
  Rng rng(1, "weighted");
  const std::array<double, 4> weights = {1.0, 0.0, 3.0, 0.0};
  std::array<int, 4> counts{};
  for (int i = 0; i < 40'000; ++i) ++counts[rng.Weighted(weights)];
  EXPECT_NEAR(counts[0], 10'000, 400);
  EXPECT_EQ(counts[1], 0);
  EXPECT_NEAR(counts[2], 30'000, 400);
  EXPECT_EQ(counts[3], 0);
}

TEST(Rng, ShuffleKeepsTheElements) {
  Rng rng(1, "shuffle");
  std::vector<int> items = {1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<int> shuffled = items;
  rng.Shuffle(shuffled);
  EXPECT_NE(shuffled, items);
  std::sort(shuffled.begin(), shuffled.end());
  EXPECT_EQ(shuffled, items);
}

TEST(Rng, NothingIsDrawnFromNothing) {
  Rng rng(1, "empty");
  EXPECT_THROW(rng.Below(0), Error);
  EXPECT_THROW(rng.Between(2, 1), Error);
  const std::array<double, 2> none = {0.0, 0.0};
  EXPECT_THROW(rng.Weighted(none), Error);
}

}  // namespace
}  // namespace bulletnav::sim
