// SPDX-License-Identifier: MIT
#include "agent/integer/integer_functions.h"

#include <algorithm>
#include <array>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << kShareBits;
/// 1 / ln 2 in units of 2^-30.
constexpr std::int64_t kLog2OfE = 1549082005;
/// ln(2)^n / n! in units of 2^-30, from n = 0 on: the series of 2^-f for f in [0, 1).
constexpr std::array<std::int64_t, 10> kSeries = {
    1073741824, 744261118, 257941248, 59597083, 10327387, 1431680, 165394, 16377, 1419, 109};

}  // namespace

std::int64_t ExpOf(std::int64_t logit) {
  BULLETNAV_CHECK(logit <= 0);
  constexpr std::int64_t kLeast = -(std::int64_t{32} << kLogitBits);
  const std::int64_t halvings = -std::max(logit, kLeast) * kLog2OfE;  // of 2^-(30 + kLogitBits)
  const std::int64_t whole = halvings >> (kShareBits + kLogitBits);
  const std::int64_t part = (halvings >> kLogitBits) & (kOne - 1);
  std::int64_t value = 0;
  for (std::size_t i = kSeries.size(); i-- > 0;) {
    value = kSeries[i] - ((value * part) >> kShareBits);
  }
  return value >> whole;
}

std::int64_t SigmoidOf(std::int64_t logit) {
  const std::int64_t power = ExpOf(logit > 0 ? -logit : logit);
  const std::int64_t larger = (kOne * kOne) / (kOne + power);
  return logit > 0 ? larger : kOne - larger;
}

void SoftmaxOf(std::span<const std::int32_t> logits, std::span<float> probabilities) {
  BULLETNAV_CHECK_EQ(logits.size(), probabilities.size());
  const std::int64_t largest = *std::max_element(logits.begin(), logits.end());
  std::int64_t sum = 0;
  for (const std::int64_t logit : logits) sum += ExpOf(logit - largest);
  for (std::size_t i = 0; i < logits.size(); ++i) {
    probabilities[i] = ShareToFloat((ExpOf(logits[i] - largest) << kShareBits) / sum);
  }
}

}  // namespace bulletnav::agent
