// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/binary_descriptor.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "tests/agent/slam/retrieval/random_descriptors.h"

namespace bulletnav::agent {
namespace {

int CountedBitByBit(const BinaryDescriptor& a, const BinaryDescriptor& b) {
  int differ = 0;
  for (std::size_t i = 0; i < kDescriptorBits; ++i) {
    if (((a[i / 64] ^ b[i / 64]) >> (i % 64) & 1U) != 0) ++differ;
  }
  return differ;
}

TEST(CountDistances, AreTheBitsThatDiffer) {
  sim::Rng rng(1, "descriptors");
  std::vector<BinaryDescriptor> all;
  for (int i = 0; i < 50; ++i) all.push_back(tests::RandomDescriptor(&rng));
  all.push_back({});
  all.push_back({~0ULL, ~0ULL, ~0ULL, ~0ULL});
  const std::vector<int> which = {51, 3, 3, 0, 50};
  std::vector<int> bits(all.size());
  std::vector<int> chosen(which.size());
  for (const BinaryDescriptor& from : all) {
    CountDistances(from, all, bits);
    CountDistances(from, all, which, chosen);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(bits[i], CountedBitByBit(from, all[i]));
      EXPECT_EQ(bits[i], Distance(from, all[i]));
    }
    for (std::size_t i = 0; i < which.size(); ++i) {
      EXPECT_EQ(chosen[i], bits[static_cast<std::size_t>(which[i])]);
    }
  }
}

TEST(NearestTo, IsTheFirstOfThoseWithFewestBits) {
  sim::Rng rng(2, "descriptors");
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<BinaryDescriptor> all;
    for (int i = rng.Between(1, 12); i > 0; --i) all.push_back(tests::RandomDescriptor(&rng));
    all.push_back(all.front());
    const BinaryDescriptor from = rng.Chance(0.3) ? all.front() : tests::RandomDescriptor(&rng);
    std::vector<int> bits(all.size());
    CountDistances(from, all, bits);
    const auto least = std::min_element(bits.begin(), bits.end());
    EXPECT_EQ(NearestTo(from, all), static_cast<std::size_t>(least - bits.begin()));
  }
}

}  // namespace
}  // namespace bulletnav::agent
