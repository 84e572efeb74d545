// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/truth/loop_truth.h"

namespace bulletnav::bench {

/// What drives have of one detector by one truth, for tables and charts.
using Rankings = std::vector<const RankingOutcome*>;

/// Of the `detector`-th of each drive that has one and a loop of this kind to find; they point into
/// the results.
Rankings RankingsOf(const std::vector<const DriveResult*>& results, std::size_t detector,
                    LoopKind kind);
Rankings RankingsOf(const std::vector<const DriveResult*>& results, std::size_t detector,
                    HeadingBin bin);

/// Mean of what `value` tells of each; 0 of none.
template <class Value>
double MeanOf(const Rankings& rankings, const Value& value) {
  double sum = 0.0;
  for (const RankingOutcome* ranking : rankings) sum += value(*ranking);
  return rankings.empty() ? 0.0 : sum / static_cast<double>(rankings.size());
}

}  // namespace bulletnav::bench
