// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

namespace bulletnav::bench {

/// One answer to a question of yes or no: how sure of yes, and whether yes was right.
struct Answer {
  float score = 0.0f;
  bool is_true = false;
};

/// What comes of saying yes from a threshold on.
struct PrecisionRecall {
  double threshold = 0.0;
  double precision = 0.0;
  double recall = 0.0;

  template <class V>
  void Visit(V& v) {
    v("threshold", threshold);
    v("precision", precision);
    v("recall", recall);
  }
};

/// One point for each score that occurs, by falling score; equal scores stand together. Empty if
/// yes is never right.
std::vector<PrecisionRecall> PrecisionRecallCurve(std::vector<Answer> answers);

/// Sum over a curve of precision times the recall that is won: the area under it, without
/// interpolation. Guessing gives the share of yes; 0 for an empty curve.
double AveragePrecision(std::span<const PrecisionRecall> curve);

/// Points of a curve at every 1/steps of recall, for drawing.
std::vector<PrecisionRecall> Thin(std::span<const PrecisionRecall> curve, int steps);

/// Ranks from 1, equal values share the mean of theirs.
std::vector<double> Ranks(std::span<const double> values);

/// Spearman's rank correlation, in [-1, 1]; 0 if either side is constant. Expects: as many of one
/// as of the other (checked). Source: Spearman, 1904; Kendall, "Rank correlation methods", 1948,
/// for ties.
double RankCorrelation(std::span<const double> a, std::span<const double> b);

}  // namespace bulletnav::bench
