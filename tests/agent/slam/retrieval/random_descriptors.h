// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/slam/retrieval/binary_descriptor.h"
#include "sim/math/rng.h"

namespace bulletnav::agent::tests {

inline BinaryDescriptor RandomDescriptor(sim::Rng* rng) {
  BinaryDescriptor descriptor{};
  for (std::uint64_t& word : descriptor) {
    const std::uint64_t high = rng->Next();
    word = high << 32 | rng->Next();
  }
  return descriptor;
}

/// The same with some bits turned over.
inline BinaryDescriptor Near(BinaryDescriptor descriptor, int bits, sim::Rng* rng) {
  for (int i = 0; i < bits; ++i) {
    const int bit = rng->Below(kDescriptorBits);
    descriptor[static_cast<std::size_t>(bit / 64)] ^= std::uint64_t{1} << (bit % 64);
  }
  return descriptor;
}

/// Pictures of places: descriptors near some of a few prototypes, place by place.
inline std::vector<std::vector<BinaryDescriptor>> RandomPictures(int pictures, int each, int kinds,
                                                                 sim::Rng* rng) {
  std::vector<BinaryDescriptor> prototypes;
  for (int i = 0; i < kinds; ++i) prototypes.push_back(RandomDescriptor(rng));
  std::vector<std::vector<BinaryDescriptor>> all(static_cast<std::size_t>(pictures));
  for (auto& picture : all) {
    const int first = rng->Below(kinds);
    for (int i = 0; i < each; ++i) {
      const int kind = (first + rng->Below(kinds / 3)) % kinds;
      picture.push_back(Near(prototypes[static_cast<std::size_t>(kind)], 12, rng));
    }
  }
  return all;
}

}  // namespace bulletnav::agent::tests
