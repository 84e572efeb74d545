// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "benchmark/base/ranking.h"

namespace bulletnav::bench {

/// How well a detector of loops ranks pairs of frames.
struct DetectionFigures {
  double average_precision = 0.0;
  double recall_at_1 = 0.0;    // the most that is found without a mistake
  double recall_at_099 = 0.0;  // with at most one of a hundred wrong
  double recall_at_09 = 0.0;   // one of ten
  double guessing = 0.0;       // precision of accepting every pair there is

  template <class V>
  void Visit(V& v) {
    v("average_precision", average_precision);
    v("recall_at_1", recall_at_1);
    v("recall_at_099", recall_at_099);
    v("recall_at_09", recall_at_09);
    v("guessing", guessing);
  }
};

/// How many pairs there are to find things in.
struct PairCounts {
  std::int64_t true_pairs = 0;  // loops, whether the detector named them or not
  std::int64_t all_pairs = 0;
};

/// The curve of what a detector answered, with recall over all loops there are: those it never
/// names are not found. Throws sim::Error if it found more loops than there are.
std::vector<PrecisionRecall> LoopCurve(std::vector<Answer> answers, const PairCounts& pairs);

/// The largest recall at which precision is at least `precision`; 0 if it never is.
double MaxRecall(std::span<const PrecisionRecall> curve, double precision);

/// Of a LoopCurve of the same pairs.
DetectionFigures MeasureCurve(std::span<const PrecisionRecall> curve, const PairCounts& pairs);
DetectionFigures MeasureDetection(std::vector<Answer> answers, const PairCounts& pairs);

/// A query's candidates, best first: whether each is right. Only of queries that have a right one.
using RankedTruth = std::vector<bool>;

/// Share of queries with a right one among their first k. Throws sim::Error without queries or for
/// k below 1.
double RecallAt(std::span<const RankedTruth> queries, int k);

}  // namespace bulletnav::bench
