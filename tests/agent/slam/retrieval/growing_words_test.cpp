// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/growing_words.h"

#include <set>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/agent/slam/retrieval/random_descriptors.h"

namespace bulletnav::agent {
namespace {

using Descriptors = std::vector<BinaryDescriptor>;

Descriptors RandomOnes(int count, sim::Rng* rng) {
  Descriptors descriptors;
  for (int i = 0; i < count; ++i) descriptors.push_back(tests::RandomDescriptor(rng));
  return descriptors;
}

TEST(GrowingWords, WhatIsNewIsAWordOfItsOwn) {
  sim::Rng rng(1, "words");
  GrowingWords words({});
  const std::vector<int> found = words.Take(RandomOnes(500, &rng));
  EXPECT_EQ(std::set<int>(found.begin(), found.end()).size(), 500u);
  EXPECT_EQ(words.size(), 500);
}

TEST(GrowingWords, WhatIsSeenAgainIsTheSameWord) {
  sim::Rng rng(2, "words");
  const Descriptors first = RandomOnes(500, &rng);
  Descriptors again;
  for (const BinaryDescriptor& descriptor : first) {
    again.push_back(tests::Near(descriptor, 25, &rng));
  }
  GrowingWords words({});
  const std::vector<int> before = words.Take(first);
  const std::vector<int> after = words.Take(again);
  int same = 0;
  for (std::size_t i = 0; i < before.size(); ++i) same += before[i] == after[i] ? 1 : 0;
  EXPECT_GT(same, 495);
}

/// Against a search of all words: neighbours that the tables miss are few.
TEST(GrowingWords, FindsWhatASlowSearchFinds) {
  sim::Rng rng(3, "words");
  const auto pictures = tests::RandomPictures(30, 40, 60, &rng);
  GrowingWords words({});
  Descriptors slow;
  int differ = 0;
  for (const auto& picture : pictures) {
    for (const BinaryDescriptor& descriptor : picture) {
      int best = kDescriptorBits;
      int second = kDescriptorBits;
      for (const BinaryDescriptor& word : slow) {
        const int bits = Distance(word, descriptor);
        second = std::min(second, std::max(best, bits));
        best = std::min(best, bits);
      }
      const bool is_known = best <= 64 && best <= 0.8 * second;
      if (!is_known) slow.push_back(descriptor);
      const int size = words.size();
      words.Take({&descriptor, 1});
      differ += (words.size() == size) == is_known ? 0 : 1;
    }
  }
  EXPECT_LE(differ, 24);  // of 1200
}

TEST(GrowingWords, BadSpecsAreRefused) {
  EXPECT_THROW(GrowingWords({.ratio = 0.0}), sim::Error);
  EXPECT_THROW(GrowingWords({.tables = 0}), sim::Error);
  EXPECT_THROW(GrowingWords({.most_bits = -1}), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
