// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "agent/slam/retrieval/majority_clusters.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Makes the nodes of a tree, each with a generator of its own.
class Vocabulary::Grower {
 public:
  Grower(const VocabularySpec& spec, Vocabulary* tree)
      : spec_(spec), rng_(spec.seed, "vocabulary"), tree_(*tree) {}

  void Grow(int node, const std::vector<BinaryDescriptor>& descriptors, int level) {
    const auto is_same = [&](const BinaryDescriptor& d) {
      return d == descriptors.front();
    };
    if (level == spec_.levels || std::all_of(descriptors.begin(), descriptors.end(), is_same)) {
      At(node).word = words_++;
      return;
    }
    sim::Rng rng = rng_.Fork("node", static_cast<std::uint64_t>(node));
    const MajorityClusters clusters = ClusterByMajority(descriptors, spec_.branches, &rng);
    std::vector<std::vector<BinaryDescriptor>> members(clusters.centres.size());
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      members[static_cast<std::size_t>(clusters.group[i])].push_back(descriptors[i]);
    }
    const int first = static_cast<int>(tree_.nodes_.size());
    At(node).first_child = first;
    At(node).children = static_cast<int>(members.size());
    tree_.nodes_.resize(tree_.nodes_.size() + clusters.centres.size());
    tree_.centres_.insert(tree_.centres_.end(), clusters.centres.begin(), clusters.centres.end());
    for (std::size_t i = 0; i < members.size(); ++i) {
      Grow(first + static_cast<int>(i), members[i], level + 1);
    }
  }

  int words() const { return words_; }

 private:
  Node& At(int node) { return tree_.nodes_[static_cast<std::size_t>(node)]; }

  const VocabularySpec& spec_;
  sim::Rng rng_;
  Vocabulary& tree_;
  int words_ = 0;
};

double Similarity(const WordVector& a, const WordVector& b) {
  double common = 0.0;
  auto it = b.begin();
  for (const auto& [word, weight] : a) {
    while (it != b.end() && it->first < word) ++it;
    if (it == b.end()) break;
    if (it->first == word) common += CommonWeight(weight, it->second);
  }
  return common / 2.0;
}

WordLookup::WordLookup(const WordVector& picture, int words)
    : weight_(static_cast<std::size_t>(words), 0.0) {
  for (const auto& [word, weight] : picture) {
    BULLETNAV_CHECK(word >= 0 && word < words);
    weight_[static_cast<std::size_t>(word)] = weight;
  }
}

double WordLookup::SimilarityTo(const WordVector& other) const {
  // In the order of Similarity's sum; words that are not in both add exactly 0.
  double common = 0.0;
  for (const auto& [word, weight] : other) {
    common += CommonWeight(weight_[static_cast<std::size_t>(word)], weight);
  }
  return common / 2.0;
}

void VocabularySpec::Validate() const {
  if (branches < 2 || levels < 1) throw sim::Error("expected branches >= 2 and levels >= 1");
}

Vocabulary::Vocabulary(std::span<const std::vector<BinaryDescriptor>> pictures,
                       const VocabularySpec& spec) {
  spec.Validate();
  std::vector<BinaryDescriptor> all;
  for (const auto& picture : pictures) all.insert(all.end(), picture.begin(), picture.end());
  if (all.empty()) {
    throw sim::Error("a vocabulary needs descriptors, and no picture has any; give others");
  }
  nodes_.emplace_back();
  centres_.emplace_back();
  Grower grower(spec, this);
  grower.Grow(0, all, 0);
  std::vector<int> pictures_with(static_cast<std::size_t>(grower.words()), 0);
  for (const auto& picture : pictures) {
    std::set<int> words;
    for (const BinaryDescriptor& descriptor : picture) words.insert(WordOf(descriptor));
    for (const int word : words) ++pictures_with[static_cast<std::size_t>(word)];
  }
  weights_.reserve(pictures_with.size());
  for (const int count : pictures_with) {
    // A word none of whose descriptors comes down to it again never counts.
    const double share = static_cast<double>(pictures.size()) / std::max(1, count);
    weights_.push_back(count > 0 ? std::log(share) : 0.0);
  }
}

const Vocabulary::Node* Vocabulary::NearestChild(const Node& node,
                                                 const BinaryDescriptor& descriptor) const {
  const auto first = static_cast<std::size_t>(node.first_child);
  const auto children = std::span(centres_).subspan(first, static_cast<std::size_t>(node.children));
  return &nodes_[first + NearestTo(descriptor, children)];
}

int Vocabulary::WordOf(const BinaryDescriptor& descriptor) const {
  const Node* node = &nodes_.front();
  while (node->word < 0) node = NearestChild(*node, descriptor);
  return node->word;
}

int Vocabulary::NodeOf(const BinaryDescriptor& descriptor, int levels) const {
  const Node* node = &nodes_.front();
  for (int level = 0; level < levels && node->word < 0; ++level) {
    node = NearestChild(*node, descriptor);
  }
  return static_cast<int>(node - nodes_.data());
}

WordVector Vocabulary::Describe(std::span<const BinaryDescriptor> descriptors) const {
  std::map<int, double> sums;
  double total = 0.0;
  for (const BinaryDescriptor& descriptor : descriptors) {
    const int word = WordOf(descriptor);
    if (weight(word) == 0.0) continue;
    sums[word] += weight(word);
    total += weight(word);
  }
  WordVector vector(sums.begin(), sums.end());
  for (auto& [word, value] : vector) value /= total;
  return vector;
}

}  // namespace bulletnav::agent
