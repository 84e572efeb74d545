// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace bulletnav::agent {

/// What is around a point of a picture as 256 yes or no, as ORB gives: bit i is bit i % 64 of word
/// i / 64. Source: Rublee et al., "ORB: an efficient alternative to SIFT or SURF", ICCV 2011.
using BinaryDescriptor = std::array<std::uint64_t, 4>;

inline constexpr int kDescriptorBits = 256;

/// Bits that differ.
inline int Distance(const BinaryDescriptor& a, const BinaryDescriptor& b) {
  int distance = 0;
  for (std::size_t word = 0; word < a.size(); ++word) distance += std::popcount(a[word] ^ b[word]);
  return distance;
}

}  // namespace bulletnav::agent
