// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/topology/clusters.h"
#include "agent/slam/topology/sequences.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// The second paper's hierarchy on words of corners instead of learned descriptors: all frames of
/// the drive are clustered, the number of clusters by the elbow; consecutive frames of a cluster
/// are a sequence; sequences are joined that are alike as wholes; and only frames of joined
/// sequences are compared one by one. It needs the whole drive, so that it answers at its end.
/// Frames are clustered by how often they have each upper node of the vocabulary; sequences are
/// described by the mean of that; frames are compared by all words, as `bow` compares them.
/// Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section III.
class WordsHierarchy final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "words_hierarchy";

  struct Config {
    int levels = 2;  // of the vocabulary's tree that clusters see
    int most_clusters = 60;
    int starts = 3;                  // of clustering, for each number of clusters
    int shortest = 3;                // frames of a sequence; shorter ones join a neighbour
    double least_sequence = 0.9;     // t_s, cosine of two sequences that are joined
    double least_frame = 0.3;        // t_g, likeness of two frames over that of neighbours
    double least_neighbour = 0.005;  // frames less like the one before tell nothing
    std::uint64_t seed = 1;

    template <class V>
    void Visit(V& v) {
      v("levels", levels);
      v("most_clusters", most_clusters);
      v("starts", starts);
      v("shortest", shortest);
      v("least_sequence", least_sequence);
      v("least_frame", least_frame);
      v("least_neighbour", least_neighbour);
      v("seed", seed);
    }
    void Validate() const {
      if (levels < 1 || most_clusters < 2 || starts < 1 || shortest < 1) {
        throw sim::Error(
            "levels, starts and shortest must be at least 1, most_clusters at least 2");
      }
    }
  };

  WordsHierarchy(const Config& config, const LoopContext& context)
      : config_(config), vocabulary_(context.vocabulary) {
    if (!vocabulary_)
      throw sim::Error(
          "the detector 'words_hierarchy' needs a vocabulary; add 'vocabulary' to the config");
  }

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    Frame& kept = frames_.emplace_back();
    kept.comparable = frame.comparable;
    kept.words = vocabulary_->Describe(frame.features->descriptors);
    for (const BinaryDescriptor& descriptor : frame.features->descriptors) {
      kept.nodes[vocabulary_->NodeOf(descriptor, config_.levels)] += 1.0f;
    }
    return {};
  }

  std::vector<LoopCandidate> Finish() override {
    std::vector<LoopCandidate> candidates;
    if (frames_.empty()) return candidates;
    const Eigen::MatrixXf points = Points();
    sim::Rng rng(config_.seed, "clusters");
    const Clusters clusters =
        ClusterByElbow(points, {.most = config_.most_clusters, .starts = config_.starts}, &rng);
    const std::vector<Sequence> sequences = SequencesOf(clusters.group, config_.shortest);
    trace_ = {sequences, clusters.tried, clusters.spreads, {}};
    const Eigen::MatrixXf wholes = WholesOf(points, sequences);
    for (std::size_t later = 0; later < sequences.size(); ++later) {
      const std::vector<Sequence> joined = JoinedWith(later, sequences, wholes);
      for (int frame = sequences[later].first; frame <= sequences[later].last; ++frame) {
        Compare(frame, joined, &candidates);
      }
    }
    return candidates;
  }

  SequenceTrace Trace() const override { return trace_; }

 private:
  struct Frame {
    int comparable = 0;
    WordVector words;
    std::map<int, float> nodes;  // corners by upper node of the tree
  };

  /// A row a frame: square roots of the shares of nodes, so that rows have length 1.
  Eigen::MatrixXf Points() const {
    std::set<int> all;
    for (const Frame& frame : frames_) {
      for (const auto& [node, count] : frame.nodes) all.insert(node);
    }
    std::map<int, Eigen::Index> columns;
    for (const int node : all) columns.emplace(node, static_cast<Eigen::Index>(columns.size()));
    Eigen::MatrixXf points =
        Eigen::MatrixXf::Zero(static_cast<Eigen::Index>(frames_.size()),
                              std::max<Eigen::Index>(1, static_cast<Eigen::Index>(all.size())));
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      float sum = 0.0f;
      for (const auto& [node, count] : frames_[i].nodes) sum += count;
      for (const auto& [node, count] : frames_[i].nodes) {
        points(static_cast<Eigen::Index>(i), columns.at(node)) = std::sqrt(count / sum);
      }
    }
    return points;
  }

  static Eigen::MatrixXf WholesOf(const Eigen::MatrixXf& points,
                                  const std::vector<Sequence>& sequences) {
    Eigen::MatrixXf wholes(static_cast<Eigen::Index>(sequences.size()), points.cols());
    for (std::size_t i = 0; i < sequences.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      wholes.row(row) = points.middleRows(sequences[i].first, sequences[i].size()).colwise().mean();
      const float length = wholes.row(row).norm();
      if (length > 0.0f) wholes.row(row) /= length;
    }
    return wholes;
  }

  /// The sequences up to one that are like it, itself among them: a long one may come back.
  std::vector<Sequence> JoinedWith(std::size_t later, const std::vector<Sequence>& sequences,
                                   const Eigen::MatrixXf& wholes) {
    std::vector<Sequence> joined;
    for (std::size_t i = 0; i <= later; ++i) {
      const double cosine = wholes.row(static_cast<Eigen::Index>(i))
                                .dot(wholes.row(static_cast<Eigen::Index>(later)));
      if (cosine < config_.least_sequence) continue;
      joined.push_back(sequences[i]);
      if (i < later) trace_.joined.emplace_back(static_cast<int>(later), static_cast<int>(i));
    }
    return joined;
  }

  /// Frames of joined sequences, and the best of them as a loop.
  void Compare(int number, const std::vector<Sequence>& joined,
               std::vector<LoopCandidate>* candidates) const {
    if (number == 0) return;
    const Frame& frame = frames_[static_cast<std::size_t>(number)];
    const double neighbour =
        Similarity(frame.words, frames_[static_cast<std::size_t>(number) - 1].words);
    if (neighbour < config_.least_neighbour || neighbour <= 0.0) return;
    const WordLookup words(frame.words, vocabulary_->words());
    const std::size_t first = candidates->size();
    for (const Sequence& sequence : joined) {
      const int end = std::min(sequence.last + 1, frame.comparable);
      for (int earlier = sequence.first; earlier < end; ++earlier) {
        const double alike = words.SimilarityTo(frames_[static_cast<std::size_t>(earlier)].words);
        if (alike > 0.0) candidates->push_back({number, earlier, alike / neighbour, false});
      }
    }
    const auto best =
        std::max_element(candidates->begin() + static_cast<std::ptrdiff_t>(first),
                         candidates->end(), [](const LoopCandidate& a, const LoopCandidate& b) {
                           return a.score < b.score;
                         });
    if (best != candidates->end() && best->score >= config_.least_frame) best->is_proposed = true;
  }

  Config config_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  std::vector<Frame> frames_;
  SequenceTrace trace_;
};

const LoopDetectorRegistration<WordsHierarchy> registration;

}  // namespace
}  // namespace bulletnav::agent
