// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "benchmark/training/supervised/scene_samples.h"

namespace bulletnav::bench {

/// Counts over the labels of any number of scenes.
class LabelStatistics {
 public:
  static constexpr int kScoreBins = 10;

  void Add(const SceneSamples& samples);

  std::int64_t pairs() const { return pairs_; }
  /// Of the ordered pairs of different places: the share of one node.
  double connected_share() const;
  /// Explorable directions a place.
  double mean_explorable() const;
  /// Share of the places without any.
  double share_without_explorable() const;
  /// Scores of pairs that are not of one node, in ten bins from 0 to 1; the last one holds 1.
  const std::array<std::int64_t, kScoreBins>& scores() const { return scores_; }

  /// For people, some lines.
  std::string ToText() const;

 private:
  void AddScores(const PairLabel& label);

  std::int64_t scenes_ = 0;
  std::int64_t points_ = 0;
  std::int64_t pairs_ = 0;
  std::int64_t different_ = 0;
  std::int64_t connected_ = 0;
  std::int64_t explorable_ = 0;
  std::int64_t without_explorable_ = 0;
  std::array<std::int64_t, kScoreBins> scores_{};
};

}  // namespace bulletnav::bench
