// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::agent {

/// Generalised mean of bytes, channel by channel: (mean of x^p)^(1/p), between the mean (p = 1) and
/// the largest (p large). Powers come from a table of whole numbers, so that sums are exact.
/// Source: Radenovic, Tolias and Chum, "Fine-tuning CNN image retrieval with no human annotation",
/// TPAMI 2018.
class Gem {
 public:
  /// Results count in steps of 2^-kBits.
  static constexpr int kBits = 4;
  static constexpr int kLargest = 255 << kBits;

  /// Throws sim::Error for an exponent outside of 1 to 8.
  explicit Gem(double exponent);

  /// Of `places`, each so many bytes; one result a byte. Expects: as many bytes each, at least one
  /// place (checked).
  std::vector<std::int16_t> Pool(std::span<const std::uint8_t* const> places, int channels) const;

 private:
  double exponent_;
  std::array<std::int64_t, 256> powers_;
};

}  // namespace bulletnav::agent
