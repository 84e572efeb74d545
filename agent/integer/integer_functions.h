// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

namespace bulletnav::agent {

/// Logits count in units of 2^-kLogitBits.
inline constexpr int kLogitBits = 16;
inline constexpr double kLogitStep = 1.0 / (1 << kLogitBits);
/// Probabilities count in units of 2^-kShareBits.
inline constexpr int kShareBits = 30;

/// exp(x) for x <= 0 in units of 2^-kShareBits, within 16 units; from integers alone, as the
/// functions below. Expects: logit <= 0 (checked).
std::int64_t ExpOf(std::int64_t logit);
/// 1 / (1 + exp(-x)).
std::int64_t SigmoidOf(std::int64_t logit);
/// exp(x_i) over their sum; sums up to 1 but for rounding down.
void SoftmaxOf(std::span<const std::int32_t> logits, std::span<float> probabilities);

/// As a number in [0, 1].
inline float ShareToFloat(std::int64_t share) {
  return static_cast<float>(static_cast<double>(share) / (1 << kShareBits));
}

}  // namespace bulletnav::agent
