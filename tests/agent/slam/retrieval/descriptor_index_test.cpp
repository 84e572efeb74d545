// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/descriptor_index.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr int kSize = 24;

PictureDescriptor Random(sim::Rng* rng) {
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < kSize; ++i) numbers.push_back(rng->Between(-1000, 1000));
  return DirectionOf(numbers);
}

TEST(DescriptorIndex, FindsWhatSortingAllCosinesFinds) {
  sim::Rng rng(1, "descriptors");
  std::vector<PictureDescriptor> all;
  DescriptorIndex index(kSize);
  for (int i = 0; i < 300; ++i) {
    // Every tenth is there twice.
    all.push_back(i % 10 == 9 ? all[static_cast<std::size_t>(i - 5)] : Random(&rng));
    index.Add(all.back());
  }
  EXPECT_EQ(index.count(), 300);
  EXPECT_EQ(index.bytes(), 300u * kSize * 2u);
  for (const int among : {0, 1, 7, 300}) {
    const PictureDescriptor query = Random(&rng);
    std::vector<LikeDescriptor> sorted;
    for (int i = 0; i < among; ++i) {
      sorted.push_back({i, Cosine(query, all[static_cast<std::size_t>(i)])});
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
      return a.cosine > b.cosine;
    });
    sorted.resize(std::min<std::size_t>(sorted.size(), 10));
    const std::vector<LikeDescriptor> found = index.MostLike(query, 10, among);
    ASSERT_EQ(found.size(), sorted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].number, sorted[i].number);
      EXPECT_EQ(found[i].cosine, sorted[i].cosine);
    }
  }
}

}  // namespace
}  // namespace bulletnav::agent
