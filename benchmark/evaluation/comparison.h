// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/evaluation/episode_result.h"
#include "benchmark/evaluation/statistics.h"

namespace bulletnav::bench {

/// Two agents, or one agent of two runs, on the same episodes with the same seed.
struct ComparisonRow {
  std::string agent_a;
  std::string agent_b;
  std::string setting;
  std::string condition;
  std::string difficulty;  // "easy", "medium", "hard", "overall"
  double success_a = 0.0;
  double success_b = 0.0;
  double spl_a = 0.0;
  double spl_b = 0.0;
  PairedDifference success;  // b - a
  PairedDifference spl;
};

struct Comparison {
  std::vector<ComparisonRow> rows;
  int only_a = 0;  // results without a partner, which are left out
  int only_b = 0;
};

/// Pairs results by setting, condition, seed, scene and episode. Without `agents` each agent is
/// compared with its namesake; with it, the first, of run a, with the second, of run b. An episode
/// of several goals counts with their mean. Throws sim::Error, listing the agents, if there is
/// nothing to pair.
Comparison CompareRuns(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                       const std::optional<std::pair<std::string, std::string>>& agents);

/// A table for the terminal: both runs' figures, the differences, their 95% intervals and p.
std::string ToText(const Comparison& comparison);

}  // namespace bulletnav::bench
