// SPDX-License-Identifier: MIT
#include "agent/integer/integer_functions.h"

#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

TEST(IntegerFunctions, ExpIsThatOfReals) {
  for (std::int64_t logit = 0; logit >= -2'400'000; logit -= 7) {
    EXPECT_NEAR(std::ldexp(static_cast<double>(ExpOf(logit)), -kShareBits),
                std::exp(static_cast<double>(logit) * kLogitStep),
                16 * std::ldexp(1.0, -kShareBits));
  }
}

TEST(IntegerFunctions, SigmoidIsThatOfReals) {
  std::int64_t last = -1;
  for (std::int64_t logit = -2'100'000; logit <= 2'100'000; logit += 5) {
    const std::int64_t share = SigmoidOf(logit);
    EXPECT_NEAR(std::ldexp(static_cast<double>(share), -kShareBits),
                1.0 / (1.0 + std::exp(static_cast<double>(-logit) * kLogitStep)), 1e-7);
    EXPECT_GE(share, last);
    last = share;
  }
  EXPECT_EQ(SigmoidOf(0), std::int64_t{1} << (kShareBits - 1));
}

TEST(IntegerFunctions, SoftmaxIsThatOfReals) {
  const std::array<std::int32_t, 5> logits = {-40'000'000, 0, 65536, 131072, 65536};
  std::array<float, 5> shares{};
  SoftmaxOf(logits, shares);
  double sum = 0.0;
  for (const std::int32_t logit : logits) sum += std::exp(logit * kLogitStep);
  for (std::size_t i = 0; i < logits.size(); ++i) {
    EXPECT_NEAR(shares[i], std::exp(logits[i] * kLogitStep) / sum, 1e-6);
  }
  EXPECT_EQ(shares[2], shares[4]);
  const std::array<std::int32_t, 3> extreme = {1 << 30, -(1 << 30), -(1 << 30)};
  std::array<float, 3> all{};
  SoftmaxOf(extreme, all);
  EXPECT_EQ(all[0], 1.0f);
}

}  // namespace
}  // namespace bulletnav::agent
