// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/binary_descriptor.h"

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

/// The i-th of all, or of those that are chosen.
struct All {
  std::span<const BinaryDescriptor> descriptors;
  const BinaryDescriptor& operator[](std::size_t i) const { return descriptors[i]; }
};
struct Chosen {
  std::span<const BinaryDescriptor> descriptors;
  std::span<const int> which;
  const BinaryDescriptor& operator[](std::size_t i) const {
    return descriptors[static_cast<std::size_t>(which[i])];
  }
};

// What is inlined always is part of functions for several kinds of processors, and compiled for
// each.

[[gnu::always_inline]] inline int CountOne(const BinaryDescriptor& a, const BinaryDescriptor& b) {
  int distance = 0;
  for (std::size_t word = 0; word < a.size(); ++word) {
    distance += __builtin_popcountll(a[word] ^ b[word]);
  }
  return distance;
}

template <class To>
[[gnu::always_inline]] inline void Count(const BinaryDescriptor& from, const To& to,
                                         std::span<int> bits) {
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = CountOne(from, to[i]);
}

[[gnu::always_inline]] inline std::size_t Nearest(const BinaryDescriptor& from,
                                                  std::span<const BinaryDescriptor> to) {
  std::size_t nearest = 0;
  int least = kDescriptorBits + 1;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const int bits = CountOne(from, to[i]);
    if (bits >= least) continue;
    least = bits;
    nearest = i;
  }
  return nearest;
}

template <class To>
[[gnu::target("popcnt")]] void CountByInstruction(const BinaryDescriptor& from, const To& to,
                                                  std::span<int> bits) {
  Count(from, to, bits);
}

template <class To>
void CountByHand(const BinaryDescriptor& from, const To& to, std::span<int> bits) {
  Count(from, to, bits);
}

[[gnu::target("popcnt")]] std::size_t NearestByInstruction(const BinaryDescriptor& from,
                                                           std::span<const BinaryDescriptor> to) {
  return Nearest(from, to);
}

std::size_t NearestByHand(const BinaryDescriptor& from, std::span<const BinaryDescriptor> to) {
  return Nearest(from, to);
}

bool HasInstruction() {
  static const bool has_instruction = __builtin_cpu_supports("popcnt") != 0;
  return has_instruction;
}

template <class To>
void CountAny(const BinaryDescriptor& from, const To& to, std::span<int> bits) {
  HasInstruction() ? CountByInstruction(from, to, bits) : CountByHand(from, to, bits);
}

}  // namespace

void CountDistances(const BinaryDescriptor& from, std::span<const BinaryDescriptor> to,
                    std::span<int> bits) {
  BULLETNAV_CHECK_EQ(to.size(), bits.size());
  CountAny(from, All{to}, bits);
}

void CountDistances(const BinaryDescriptor& from, std::span<const BinaryDescriptor> all,
                    std::span<const int> which, std::span<int> bits) {
  BULLETNAV_CHECK_EQ(which.size(), bits.size());
  CountAny(from, Chosen{all, which}, bits);
}

std::size_t NearestTo(const BinaryDescriptor& from, std::span<const BinaryDescriptor> to) {
  BULLETNAV_CHECK(!to.empty());
  return HasInstruction() ? NearestByInstruction(from, to) : NearestByHand(from, to);
}

}  // namespace bulletnav::agent
