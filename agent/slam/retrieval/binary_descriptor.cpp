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

/// Part of each of the two functions below, so that it is compiled for the processors of both.
template <class To>
[[gnu::always_inline]] inline void Count(const BinaryDescriptor& from, const To& to,
                                         std::span<int> bits) {
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const BinaryDescriptor& other = to[i];
    int distance = 0;
    for (std::size_t word = 0; word < from.size(); ++word) {
      distance += __builtin_popcountll(from[word] ^ other[word]);
    }
    bits[i] = distance;
  }
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

template <class To>
void CountAny(const BinaryDescriptor& from, const To& to, std::span<int> bits) {
  static const bool has_instruction = __builtin_cpu_supports("popcnt") != 0;
  has_instruction ? CountByInstruction(from, to, bits) : CountByHand(from, to, bits);
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

}  // namespace bulletnav::agent
