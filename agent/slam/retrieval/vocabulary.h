// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "agent/slam/retrieval/binary_descriptor.h"

namespace bulletnav::agent {

/// A picture as weights of words, by rising word; absolute values sum to 1, or there are none.
using WordVector = std::vector<std::pair<int, double>>;

/// What a word that two pictures have adds to twice their similarity, by its weights in them: of
/// |a - b|_1 = 2 - sum over common words of |a| + |b| - |a - b|, as both sum to 1. 0 if one has
/// none.
inline double CommonWeight(double a, double b) {
  return std::abs(a) + std::abs(b) - std::abs(a - b);
}

/// How alike: 1 - |a - b|_1 / 2, from 0 to 1.
double Similarity(const WordVector& a, const WordVector& b);

/// A picture that is compared with many: the same as Similarity, several times as fast.
class WordLookup {
 public:
  /// Expects: words below `words` (checked).
  WordLookup(const WordVector& picture, int words);
  double SimilarityTo(const WordVector& other) const;

 private:
  std::vector<double> weight_;  // by word; 0 where the picture has none
};

struct VocabularySpec {
  int branches = 10;  // DBoW2's
  int levels = 5;     // at most branches^levels words
  std::uint64_t seed = 1;

  template <class V>
  void Visit(V& v) {
    v("branches", branches);
    v("levels", levels);
    v("seed", seed);
  }
  void Validate() const;
};

/// A tree of binary descriptors: each node's descriptors are clustered into its children; leaves
/// are words. Words count by term frequency and inverse document frequency.
/// Source: Galvez-Lopez and Tardos, "Bags of binary words for fast place recognition in image
/// sequences", T-RO 2012, section III; Nister and Stewenius, CVPR 2006.
class Vocabulary {
 public:
  /// Grown from the descriptors of pictures, of which a word's weight is ln(pictures / pictures
  /// that have it). Throws sim::Error if the spec is bad or there is no descriptor at all.
  /// Cost: descriptors x branches x levels x rounds of clustering.
  Vocabulary(std::span<const std::vector<BinaryDescriptor>> pictures, const VocabularySpec& spec);

  int words() const { return static_cast<int>(weights_.size()); }
  double weight(int word) const { return weights_[static_cast<std::size_t>(word)]; }
  /// Down the tree by the nearest child, the first of several.
  int WordOf(const BinaryDescriptor& descriptor) const;
  /// As WordOf, but only so many levels down: the number of a node of the tree, which stands for
  /// all words below it. A leaf above that level stands for itself.
  int NodeOf(const BinaryDescriptor& descriptor, int levels) const;
  /// Empty if there are no descriptors or all are of words that every picture has.
  WordVector Describe(std::span<const BinaryDescriptor> descriptors) const;

 private:
  struct Node {
    int first_child = -1;  // children stand together
    int children = 0;
    int word = -1;  // of leaves
  };
  class Grower;

  const Node* NearestChild(const Node& node, const BinaryDescriptor& descriptor) const;

  std::vector<Node> nodes_;                // the root first
  std::vector<BinaryDescriptor> centres_;  // by node
  std::vector<double> weights_;
};

}  // namespace bulletnav::agent
