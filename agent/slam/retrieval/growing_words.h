// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "agent/slam/retrieval/binary_descriptor.h"

namespace bulletnav::agent {

struct GrowingWordsSpec {
  double ratio = 0.8;      // of the distances to the nearest word and the next, at most
  int most_bits = 64;      // that a descriptor differs from its word
  int tables = 12;         // of the search for neighbours
  std::uint64_t seed = 1;  // of the bits that tables look at

  void Validate() const;
};

/// Words that are learned on the way: a descriptor that is clearly nearest to one word is that
/// word, any other is a new word. Words stay as they were first seen. Neighbours are looked for
/// where 16 bits, others in each table, are the same but for one at most: of neighbours that differ
/// in 50 bits, six in seven are found, of those nearer almost all.
/// Deterministic. Cost: a table's words over 65,536 times 17, a table and descriptor.
/// Source: Labbe and Michaud, "Appearance-based loop closure detection for online large-scale and
/// long-term operation", T-RO 2013, section III-A; Lv et al., "Multi-probe LSH", VLDB 2007.
class GrowingWords {
 public:
  /// Throws sim::Error if the spec is bad.
  explicit GrowingWords(const GrowingWordsSpec& spec);

  /// The word of each descriptor, in turn; a new word is there for the next descriptor already.
  std::vector<int> Take(std::span<const BinaryDescriptor> descriptors);
  int size() const { return static_cast<int>(words_.size()); }

 private:
  int KeyOf(const BinaryDescriptor& descriptor, std::size_t table) const;
  /// Words of the buckets of each table's key and of its neighbours, some more than once.
  std::span<const int> Candidates(std::span<const int> keys);
  int FindOrAdd(const BinaryDescriptor& descriptor);

  GrowingWordsSpec spec_;
  std::vector<BinaryDescriptor> words_;
  std::vector<std::vector<int>> bits_;         // by table, that it looks at
  std::vector<std::vector<int>> buckets_;      // by table and key: words
  std::vector<const std::vector<int>*> near_;  // of the last search
  std::vector<int> candidates_;                // some more than once
  std::vector<int> candidate_bits_;
};

}  // namespace bulletnav::agent
