// SPDX-License-Identifier: MIT
#pragma once
#include <utility>
#include <vector>

#include "agent/slam/retrieval/vocabulary.h"

namespace bulletnav::agent {

/// A picture that is like a query.
struct Likeness {
  int picture = 0;
  double similarity = 0.0;
  int common_words = 0;
};

/// Pictures by their words, so that a query looks at those alone that share words with it.
class WordIndex {
 public:
  /// For a vocabulary of so many words.
  explicit WordIndex(int words);

  /// Pictures are numbered 0, 1, ... Expects: words of the vocabulary (checked).
  int Add(const WordVector& picture);
  int size() const { return size_; }

  /// The `count` pictures before picture `before` that are most like a query, best first, the
  /// earlier of equals first; none that share no word. Cost: pictures of the query's words.
  std::vector<Likeness> MostLike(const WordVector& query, int count, int before) const;

 private:
  std::vector<std::vector<std::pair<int, double>>> pictures_;  // by word: picture, weight
  int size_ = 0;
};

}  // namespace bulletnav::agent
