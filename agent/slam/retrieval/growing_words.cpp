// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/growing_words.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr int kKeyBits = 16;
constexpr std::size_t kKeys = std::size_t{1} << kKeyBits;

/// The nearest word, and how near it and the next are.
struct NearestWord {
  int word = -1;
  int bits = kDescriptorBits;
  int second_bits = kDescriptorBits;

  /// A word may come again.
  void Take(int other, int other_bits) {
    if (other == word) return;
    if (other_bits < bits) {
      second_bits = bits;
      word = other;
      bits = other_bits;
    } else {
      second_bits = std::min(second_bits, other_bits);
    }
  }
};

}  // namespace

void GrowingWordsSpec::Validate() const {
  if (!(ratio > 0.0 && ratio <= 1.0) || most_bits < 0 || tables < 1) {
    throw sim::Error(
        "expected a ratio above 0 and at most 1, most_bits of at least 0 and a table at least");
  }
}

GrowingWords::GrowingWords(const GrowingWordsSpec& spec) : spec_(spec) {
  spec_.Validate();
  sim::Rng rng(spec_.seed, "growing words");
  std::vector<int> all(kDescriptorBits);
  std::iota(all.begin(), all.end(), 0);
  for (int table = 0; table < spec_.tables; ++table) {
    rng.Shuffle(all);
    bits_.emplace_back(all.begin(), all.begin() + kKeyBits);
  }
  buckets_.resize(bits_.size() * kKeys);
}

int GrowingWords::KeyOf(const BinaryDescriptor& descriptor, std::size_t table) const {
  unsigned key = 0;
  for (const int bit : bits_[table]) {
    const auto place = static_cast<std::size_t>(bit);
    key = key << 1U | static_cast<unsigned>((descriptor[place / 64] >> (place % 64)) & 1U);
  }
  return static_cast<int>(key);
}

/// Words lie all over the memory: what will be read is asked for early, all at once.
std::span<const int> GrowingWords::Candidates(std::span<const int> keys) {
  near_.clear();
  for (std::size_t table = 0; table < keys.size(); ++table) {
    const std::vector<int>* of_table = buckets_.data() + table * kKeys;
    near_.push_back(of_table + keys[table]);
    for (int bit = 0; bit < kKeyBits; ++bit) near_.push_back(of_table + (keys[table] ^ (1 << bit)));
  }
  for (const std::vector<int>* bucket : near_) __builtin_prefetch(bucket);
  for (const std::vector<int>* bucket : near_) __builtin_prefetch(bucket->data());
  candidates_.clear();
  for (const std::vector<int>* bucket : near_) {
    candidates_.insert(candidates_.end(), bucket->begin(), bucket->end());
  }
  for (const int word : candidates_) __builtin_prefetch(words_.data() + word);
  return candidates_;
}

int GrowingWords::FindOrAdd(const BinaryDescriptor& descriptor) {
  NearestWord nearest;
  std::vector<int> keys(bits_.size());
  for (std::size_t table = 0; table < keys.size(); ++table) keys[table] = KeyOf(descriptor, table);
  const std::span<const int> candidates = Candidates(keys);
  candidate_bits_.resize(candidates.size());
  CountDistances(descriptor, words_, candidates, candidate_bits_);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    nearest.Take(candidates[i], candidate_bits_[i]);
  }
  const bool is_clear = nearest.bits <= spec_.ratio * nearest.second_bits;
  if (nearest.word >= 0 && nearest.bits <= spec_.most_bits && is_clear) return nearest.word;
  const int added = size();
  words_.push_back(descriptor);
  for (std::size_t table = 0; table < keys.size(); ++table) {
    buckets_[table * kKeys + static_cast<std::size_t>(keys[table])].push_back(added);
  }
  return added;
}

std::vector<int> GrowingWords::Take(std::span<const BinaryDescriptor> descriptors) {
  std::vector<int> found;
  found.reserve(descriptors.size());
  for (const BinaryDescriptor& descriptor : descriptors) found.push_back(FindOrAdd(descriptor));
  return found;
}

}  // namespace bulletnav::agent
