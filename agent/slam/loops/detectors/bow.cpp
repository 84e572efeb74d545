// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/retrieval/word_index.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Bags of binary words as DBoW2 and DLoopDetector use them: a frame's likeness to earlier ones,
/// divided by that to the frame before it; neighbours in time that are alike are an island and
/// count together; a loop is proposed when the best islands of some frames in a row follow each
/// other. Source: Galvez-Lopez and Tardos, "Bags of binary words for fast place recognition in
/// image sequences", T-RO 2012, section V; settings of their DLoopDetector.
class BowDetector final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "bow";

  struct Config {
    double least_score = 0.3;  // alpha, of the normalised score
    /// Frames that are less like the one before than this, as after a quick turn, tell nothing.
    double least_neighbour = 0.005;
    int most_results = 50;
    int island_gap = 3;   // frames between matches of one island
    int consistent = 3;   // k: islands in a row that must follow each other
    int query_gap = 2;    // frames between queries that count as in a row
    int island_step = 3;  // frames between islands that follow each other

    template <class V>
    void Visit(V& v) {
      v("least_score", least_score);
      v("least_neighbour", least_neighbour);
      v("most_results", most_results);
      v("island_gap", island_gap);
      v("consistent", consistent);
      v("query_gap", query_gap);
      v("island_step", island_step);
    }
    void Validate() const {
      if (least_score < 0.0 || least_neighbour < 0.0) {
        throw sim::Error("least_score and least_neighbour must not be negative");
      }
      if (most_results < 1 || island_gap < 1 || query_gap < 1 || island_step < 0 ||
          consistent < 0) {
        throw sim::Error(
            "most_results, island_gap and query_gap must be at least 1, island_step and "
            "consistent at least 0");
      }
    }
  };

  BowDetector(const Config& config, const LoopContext& context)
      : config_(config), vocabulary_(context.vocabulary) {
    if (!vocabulary_)
      throw sim::Error("the detector 'bow' needs a vocabulary; add 'vocabulary' to the config");
    index_.emplace(vocabulary_->words());
  }

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    WordVector words = vocabulary_->Describe(frame.features->descriptors);
    const double neighbour = frame.number > 0 ? Similarity(words, last_) : 0.0;
    std::vector<LoopCandidate> candidates;
    if (neighbour >= config_.least_neighbour && neighbour > 0.0) {
      const std::vector<Likeness> like =
          index_->MostLike(words, frame.comparable, frame.comparable);
      candidates.reserve(like.size());
      for (const Likeness& one : like) {
        candidates.push_back({frame.number, one.picture, one.similarity / neighbour, false});
      }
      Propose(&candidates);
    }
    index_->Add(words);
    last_ = std::move(words);
    return candidates;
  }

 private:
  /// Matches next to each other in time, [first, last], and the one of them that is most alike.
  struct Island {
    int first = 0;
    int last = 0;
    double sum = 0.0;
    std::size_t best = 0;  // position in the candidates
  };

  /// Marks at most one of the candidates, which come best first.
  void Propose(std::vector<LoopCandidate>* candidates) {
    const std::vector<Island> islands = IslandsOf(*candidates);
    if (islands.empty()) return;
    const Island best =
        *std::max_element(islands.begin(), islands.end(), [](const Island& a, const Island& b) {
          return a.sum < b.sum;
        });
    LoopCandidate& match = (*candidates)[best.best];
    const bool in_a_row = in_a_row_ > 0 && match.later - last_query_ <= config_.query_gap;
    const bool follows = best.first <= last_island_.last + config_.island_step &&
                         last_island_.first <= best.last + config_.island_step;
    in_a_row_ = in_a_row && follows ? in_a_row_ + 1 : 1;
    last_query_ = match.later;
    last_island_ = best;
    match.is_proposed = in_a_row_ > config_.consistent;
  }

  std::vector<Island> IslandsOf(const std::vector<LoopCandidate>& candidates) const {
    std::map<int, std::size_t> by_time;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (i >= static_cast<std::size_t>(config_.most_results)) break;
      if (candidates[i].score < config_.least_score) break;
      by_time.emplace(candidates[i].earlier, i);
    }
    std::vector<Island> islands;
    for (const auto& [frame, place] : by_time) {
      if (islands.empty() || frame - islands.back().last > config_.island_gap) {
        islands.push_back({frame, frame, 0.0, place});
      }
      Island& island = islands.back();
      island.last = frame;
      island.sum += candidates[place].score;
      island.best = std::min(island.best, place);  // best first
    }
    return islands;
  }

  Config config_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  std::optional<WordIndex> index_;
  WordVector last_;
  Island last_island_;
  int last_query_ = 0;
  int in_a_row_ = 0;
};

const LoopDetectorRegistration<BowDetector> registration;

}  // namespace
}  // namespace bulletnav::agent
