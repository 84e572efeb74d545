// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/majority_clusters.h"

#include <bitset>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/agent/slam/retrieval/random_descriptors.h"

namespace bulletnav::agent {
namespace {

using ::testing::Each;
using tests::Near;
using tests::RandomDescriptor;

using Bits = std::bitset<kDescriptorBits>;

Bits BitsOf(const BinaryDescriptor& descriptor) {
  Bits bits;
  for (std::size_t i = 0; i < bits.size(); ++i)
    bits[i] = (descriptor[i / 64] >> (i % 64) & 1u) != 0;
  return bits;
}

TEST(Distance, CountsBitsThatDiffer) {
  sim::Rng rng(1, "descriptors");
  for (int i = 0; i < 50; ++i) {
    const BinaryDescriptor a = RandomDescriptor(&rng);
    const BinaryDescriptor b = RandomDescriptor(&rng);
    EXPECT_EQ(Distance(a, b), static_cast<int>((BitsOf(a) ^ BitsOf(b)).count()));
  }
}

/// No other descriptor has a smaller sum of distances; bit by bit, since bits do not mix.
TEST(MajorityOf, HasTheLeastSumOfDistances) {
  sim::Rng rng(2, "descriptors");
  for (const int count : {1, 2, 5, 8}) {
    std::vector<BinaryDescriptor> descriptors;
    for (int i = 0; i < count; ++i) descriptors.push_back(RandomDescriptor(&rng));
    const auto sum = [&](const BinaryDescriptor& centre) {
      int total = 0;
      for (const BinaryDescriptor& descriptor : descriptors) total += Distance(descriptor, centre);
      return total;
    };
    const BinaryDescriptor majority = MajorityOf(descriptors);
    for (int bit = 0; bit < kDescriptorBits; ++bit) {
      BinaryDescriptor other = majority;
      other[static_cast<std::size_t>(bit / 64)] ^= std::uint64_t{1} << (bit % 64);
      EXPECT_GE(sum(other), sum(majority));
    }
  }
}

TEST(ClusterByMajority, FindsGroupsThatAreFarApart) {
  sim::Rng rng(3, "descriptors");
  std::vector<BinaryDescriptor> prototypes;
  for (int i = 0; i < 6; ++i) prototypes.push_back(RandomDescriptor(&rng));
  std::vector<BinaryDescriptor> descriptors;
  for (int i = 0; i < 120; ++i) {
    descriptors.push_back(Near(prototypes[static_cast<std::size_t>(i % 6)], 15, &rng));
  }
  const MajorityClusters clusters = ClusterByMajority(descriptors, 6, &rng);
  ASSERT_EQ(clusters.centres.size(), 6u);
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    EXPECT_EQ(clusters.group[i], clusters.group[i % 6]);
    const auto& centre = clusters.centres[static_cast<std::size_t>(clusters.group[i])];
    EXPECT_LE(Distance(centre, prototypes[i % 6]), 3);
  }
}

TEST(ClusterByMajority, DescribesNothingAndFew) {
  sim::Rng rng(4, "descriptors");
  EXPECT_TRUE(ClusterByMajority({}, 10, &rng).centres.empty());
  const BinaryDescriptor one = RandomDescriptor(&rng);
  const std::vector<BinaryDescriptor> same(5, one);
  const MajorityClusters clusters = ClusterByMajority(same, 10, &rng);
  ASSERT_EQ(clusters.centres.size(), 1u);
  EXPECT_EQ(clusters.centres[0], one);
  EXPECT_THAT(clusters.group, Each(0));
}

/// Each is with a centre that is none farther than any, and no group is empty.
TEST(ClusterByMajority, ComesToRest) {
  sim::Rng rng(5, "descriptors");
  std::vector<BinaryDescriptor> descriptors;
  for (int i = 0; i < 300; ++i) descriptors.push_back(RandomDescriptor(&rng));
  const MajorityClusters clusters = ClusterByMajority(descriptors, 10, &rng);
  std::vector<int> members(clusters.centres.size(), 0);
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    const auto own = static_cast<std::size_t>(clusters.group[i]);
    ++members[own];
    for (const BinaryDescriptor& centre : clusters.centres) {
      EXPECT_LE(Distance(descriptors[i], clusters.centres[own]), Distance(descriptors[i], centre));
    }
  }
  EXPECT_THAT(members, Each(::testing::Gt(0)));
}

}  // namespace
}  // namespace bulletnav::agent
