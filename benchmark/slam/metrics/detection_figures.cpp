// SPDX-License-Identifier: MIT
#include "benchmark/slam/metrics/detection_figures.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {

std::vector<PrecisionRecall> LoopCurve(std::vector<Answer> answers, const PairCounts& pairs) {
  const auto found = std::count_if(answers.begin(), answers.end(), [](const Answer& answer) {
    return answer.is_true;
  });
  if (found > pairs.true_pairs || pairs.true_pairs > pairs.all_pairs) {
    throw sim::Error(
        fmt::format("{} loops were found of {} there are among {} pairs; count them "
                    "by the same truth",
                    found, pairs.true_pairs, pairs.all_pairs));
  }
  std::vector<PrecisionRecall> curve = PrecisionRecallCurve(std::move(answers));
  for (PrecisionRecall& point : curve) {
    point.recall *= static_cast<double>(found) / static_cast<double>(pairs.true_pairs);
  }
  return curve;
}

double MaxRecall(std::span<const PrecisionRecall> curve, double precision) {
  double most = 0.0;
  for (const PrecisionRecall& point : curve) {
    if (point.precision >= precision) most = std::max(most, point.recall);
  }
  return most;
}

DetectionFigures MeasureCurve(std::span<const PrecisionRecall> curve, const PairCounts& pairs) {
  DetectionFigures figures;
  figures.average_precision = AveragePrecision(curve);
  figures.recall_at_1 = MaxRecall(curve, 1.0);
  figures.recall_at_099 = MaxRecall(curve, 0.99);
  figures.recall_at_09 = MaxRecall(curve, 0.9);
  if (pairs.all_pairs > 0) {
    figures.guessing = static_cast<double>(pairs.true_pairs) / static_cast<double>(pairs.all_pairs);
  }
  return figures;
}

DetectionFigures MeasureDetection(std::vector<Answer> answers, const PairCounts& pairs) {
  return MeasureCurve(LoopCurve(std::move(answers), pairs), pairs);
}

double RecallAt(std::span<const RankedTruth> queries, int k) {
  if (queries.empty() || k < 1) {
    throw sim::Error("recall@k needs a query that has a loop, and k of at least 1");
  }
  const auto is_found = [k](const RankedTruth& query) {
    const auto depth = std::min(query.size(), static_cast<std::size_t>(k));
    const auto end = query.begin() + static_cast<std::ptrdiff_t>(depth);
    return std::find(query.begin(), end, true) != end;
  };
  const auto found = std::count_if(queries.begin(), queries.end(), is_found);
  return static_cast<double>(found) / static_cast<double>(queries.size());
}

}  // namespace bulletnav::bench
