// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/word_index.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/check.h"

namespace bulletnav::agent {

WordIndex::WordIndex(int words) : pictures_(static_cast<std::size_t>(words)) {}

int WordIndex::Add(const WordVector& picture) {
  for (const auto& [word, weight] : picture) {
    BULLETNAV_CHECK(word >= 0 && word < static_cast<int>(pictures_.size()));
    pictures_[static_cast<std::size_t>(word)].emplace_back(size_, weight);
  }
  return size_++;
}

std::vector<Likeness> WordIndex::MostLike(const WordVector& query, int count, int before) const {
  struct Common {
    double weight = 0.0;
    int words = 0;
  };
  std::vector<Common> common(static_cast<std::size_t>(std::max(0, std::min(before, size_))));
  for (const auto& [word, weight] : query) {
    for (const auto& [picture, other] : pictures_[static_cast<std::size_t>(word)]) {
      if (picture >= static_cast<int>(common.size())) break;  // they were added in order
      Common& shared = common[static_cast<std::size_t>(picture)];
      shared.weight += CommonWeight(weight, other);
      ++shared.words;
    }
  }
  std::vector<Likeness> found;
  for (std::size_t i = 0; i < common.size(); ++i) {
    if (common[i].weight <= 0.0) continue;
    found.push_back({static_cast<int>(i), common[i].weight / 2.0, common[i].words});
  }
  const auto kept = std::min(found.size(), static_cast<std::size_t>(std::max(0, count)));
  const auto is_better = [](const Likeness& a, const Likeness& b) {
    return a.similarity != b.similarity ? a.similarity > b.similarity : a.picture < b.picture;
  };
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end(),
                    is_better);
  found.resize(kept);
  return found;
}

}  // namespace bulletnav::agent
