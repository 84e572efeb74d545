// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

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

/// Bits in which each of `to` differs from a descriptor, counted by the processor's own instruction
/// where it has one. Expects: as many `bits` as `to` (checked).
void CountDistances(const BinaryDescriptor& from, std::span<const BinaryDescriptor> to,
                    std::span<int> bits);
/// The same of those of `all` that are numbered by `which`.
void CountDistances(const BinaryDescriptor& from, std::span<const BinaryDescriptor> all,
                    std::span<const int> which, std::span<int> bits);
/// Which of `to` differs in the fewest bits, the first of several. Expects: one at least (checked).
std::size_t NearestTo(const BinaryDescriptor& from, std::span<const BinaryDescriptor> to);

}  // namespace bulletnav::agent
