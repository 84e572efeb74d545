// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/retrieval/word_index.h"
#include "sim/base/error.h"
#include "tests/agent/slam/retrieval/random_descriptors.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using tests::RandomPictures;

using Pictures = std::vector<std::vector<BinaryDescriptor>>;

/// 1 - |a - b|_1 / 2 over all words.
double SlowSimilarity(const WordVector& a, const WordVector& b) {
  std::map<int, double> difference;
  for (const auto& [word, weight] : a) difference[word] += weight;
  for (const auto& [word, weight] : b) difference[word] -= weight;
  double sum = 0.0;
  for (const auto& [word, weight] : difference) sum += std::abs(weight);
  return 1.0 - sum / 2.0;
}

TEST(Vocabulary, WeighsByHowFewPicturesHaveAWord) {
  sim::Rng rng(1, "pictures");
  const Pictures pictures = RandomPictures(40, 30, 30, &rng);
  const Vocabulary vocabulary(pictures, {.branches = 4, .levels = 3});
  EXPECT_GT(vocabulary.words(), 16);
  EXPECT_LE(vocabulary.words(), 64);
  for (int word = 0; word < vocabulary.words(); ++word) {
    const auto having = std::count_if(pictures.begin(), pictures.end(), [&](const auto& picture) {
      return std::any_of(picture.begin(), picture.end(), [&](const BinaryDescriptor& d) {
        return vocabulary.WordOf(d) == word;
      });
    });
    const double expected = having > 0 ? std::log(40.0 / static_cast<double>(having)) : 0.0;
    EXPECT_DOUBLE_EQ(vocabulary.weight(word), expected);
  }
}

TEST(Vocabulary, DescribesByTermAndDocumentFrequency) {
  sim::Rng rng(2, "pictures");
  const Pictures pictures = RandomPictures(30, 25, 24, &rng);
  const Vocabulary vocabulary(pictures, {.branches = 3, .levels = 3});
  for (const auto& picture : pictures) {
    const WordVector vector = vocabulary.Describe(picture);
    EXPECT_TRUE(std::is_sorted(vector.begin(), vector.end()));
    double total = 0.0;
    for (const BinaryDescriptor& d : picture) total += vocabulary.weight(vocabulary.WordOf(d));
    double sum = 0.0;
    for (const auto& [word, value] : vector) {
      const auto times = std::count_if(picture.begin(), picture.end(), [&](const auto& d) {
        return vocabulary.WordOf(d) == word;
      });
      EXPECT_NEAR(value, static_cast<double>(times) * vocabulary.weight(word) / total, 1e-12);
      sum += value;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

/// With one level a tree is a list, and a word is the nearest of its centres: near descriptors of
/// one prototype share a word, those of others do not.
TEST(Vocabulary, TellsPrototypesApart) {
  sim::Rng rng(3, "pictures");
  Pictures pictures;
  std::vector<BinaryDescriptor> prototypes;
  for (int i = 0; i < 9; ++i) {
    prototypes.push_back(tests::RandomDescriptor(&rng));
    pictures.emplace_back();
    for (int k = 0; k < 20; ++k) pictures.back().push_back(tests::Near(prototypes.back(), 8, &rng));
  }
  const Vocabulary vocabulary(pictures, {.branches = 9, .levels = 1});
  std::set<int> words;
  for (std::size_t i = 0; i < prototypes.size(); ++i) {
    words.insert(vocabulary.WordOf(prototypes[i]));
    for (const BinaryDescriptor& d : pictures[i]) {
      EXPECT_EQ(vocabulary.WordOf(d), vocabulary.WordOf(prototypes[i]));
    }
  }
  EXPECT_EQ(words.size(), 9u);
}

TEST(Vocabulary, IsTheSameFromTheSameSeed) {
  sim::Rng rng(4, "pictures");
  const Pictures pictures = RandomPictures(20, 30, 20, &rng);
  const Vocabulary first(pictures, {.branches = 5, .levels = 3, .seed = 7});
  const Vocabulary second(pictures, {.branches = 5, .levels = 3, .seed = 7});
  ASSERT_EQ(first.words(), second.words());
  for (const auto& picture : pictures) EXPECT_EQ(first.Describe(picture), second.Describe(picture));
}

TEST(Vocabulary, TellsWhatIsWrong) {
  const Pictures none(3);
  EXPECT_THAT(([&] {
                Vocabulary(none, {});
              }),
              ThrowsMessage<sim::Error>(HasSubstr("needs descriptors")));
  const Pictures one = {{BinaryDescriptor{}}};
  EXPECT_THAT(([&] {
                Vocabulary(one, {.branches = 1});
              }),
              ThrowsMessage<sim::Error>(HasSubstr("branches >= 2")));
  const Vocabulary vocabulary(one, {});
  EXPECT_EQ(vocabulary.words(), 1);
  EXPECT_TRUE(vocabulary.Describe(one[0]).empty());  // every picture has the word
}

TEST(WordLookup, AgreesToTheBitWithSimilarity) {
  sim::Rng rng(5, "lookup");
  const Pictures pictures = RandomPictures(30, 40, 30, &rng);
  const Vocabulary vocabulary(pictures, {.branches = 4, .levels = 3});
  std::vector<WordVector> all = {{}};
  for (const auto& picture : pictures) all.push_back(vocabulary.Describe(picture));
  for (const WordVector& a : all) {
    const WordLookup lookup(a, vocabulary.words());
    for (const WordVector& b : all) EXPECT_EQ(lookup.SimilarityTo(b), Similarity(a, b));
  }
}

TEST(WordIndex, AgreesWithComparingAll) {
  sim::Rng rng(5, "pictures");
  const Pictures pictures = RandomPictures(60, 25, 40, &rng);
  const Vocabulary vocabulary(pictures, {.branches = 4, .levels = 3});
  std::vector<WordVector> vectors;
  WordIndex index(vocabulary.words());
  for (const auto& picture : pictures) {
    vectors.push_back(vocabulary.Describe(picture));
    EXPECT_EQ(index.Add(vectors.back()), static_cast<int>(vectors.size()) - 1);
  }
  for (int query = 0; query < 60; ++query) {
    const WordVector& vector = vectors[static_cast<std::size_t>(query)];
    const int before = query - 5;
    std::vector<Likeness> all;
    for (int i = 0; i < before; ++i) {
      const double similarity = SlowSimilarity(vector, vectors[static_cast<std::size_t>(i)]);
      EXPECT_NEAR(similarity, Similarity(vector, vectors[static_cast<std::size_t>(i)]), 1e-12);
      if (similarity > 1e-12) all.push_back({i, similarity});
    }
    std::stable_sort(all.begin(), all.end(), [](const Likeness& a, const Likeness& b) {
      return a.similarity > b.similarity;
    });
    const std::vector<Likeness> found = index.MostLike(vector, 8, before);
    ASSERT_EQ(found.size(), std::min<std::size_t>(8, all.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].similarity, all[i].similarity, 1e-12);
      EXPECT_LT(found[i].picture, before);
      const WordVector& other = vectors[static_cast<std::size_t>(found[i].picture)];
      const auto shared = std::count_if(other.begin(), other.end(), [&](const auto& entry) {
        return std::any_of(vector.begin(), vector.end(), [&](const auto& own) {
          return own.first == entry.first;
        });
      });
      EXPECT_EQ(found[i].common_words, shared);
    }
  }
  const std::vector<Likeness> self = index.MostLike(vectors[9], 1, 60);
  ASSERT_EQ(self.size(), 1u);
  EXPECT_EQ(self[0].picture, 9);
  EXPECT_NEAR(self[0].similarity, 1.0, 1e-12);
}

}  // namespace
}  // namespace bulletnav::agent
