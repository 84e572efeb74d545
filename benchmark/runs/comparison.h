// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/base/statistics.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// What is paired with what: names of the first run and of the second. What is not given is paired
/// with its namesake.
struct Pairing {
  using Names = std::optional<std::pair<std::string, std::string>>;
  Names agents;
  Names settings;
  Names conditions;
};

/// A main measure of the episodes that both runs have it of.
struct ComparedMeasure {
  Measure measure;
  double a = 0.0;  // means
  double b = 0.0;
  PairedDifference difference;  // b - a
};

/// Two sets of results on the same episodes with the same seed.
struct ComparisonRow {
  std::string agent_a;
  std::string agent_b;
  std::string setting;     // or "rgb -> rgbd"
  std::string condition;   // likewise
  std::string difficulty;  // "easy", "medium", "hard", "overall"
  std::vector<ComparedMeasure> measures;
};

struct Comparison {
  std::vector<ComparisonRow> rows;
  int only_a = 0;  // results without a partner, which are left out
  int only_b = 0;
};

/// Pairs results by agent, setting, condition, seed, scene and episode. An episode of several goals
/// counts with their mean. Throws sim::Error if there is nothing to pair, listing what there is,
/// and if episodes of one name start at different distances from their goals: they are not the
/// same.
Comparison CompareRuns(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                       const Pairing& pairing);

/// One agent of the first run with each other one of the second, in the order of their names, as
/// far as they share results; what has no partner is not counted. `pairing`: of settings and
/// conditions; its agents are not read. Throws sim::Error as CompareRuns does, also if the first
/// run has no such agent.
Comparison CompareWithAll(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                          const std::string& agent, const Pairing& pairing);

/// A table for the terminal: both runs' figures, the differences, their 95% intervals and p.
std::string ToText(const Comparison& comparison);
/// The same for a page, a line a row.
std::string ToMarkdown(const Comparison& comparison);

}  // namespace bulletnav::bench
