// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/report/figure.h"
#include "benchmark/training/nts_metrics.h"

namespace bulletnav::bench {

/// What a training writes down at each validation.
struct CurvePoint {
  int step = 0;
  double rate = 0.0;
  double train_loss = 0.0;  // mean since the last point
  NtsMetrics validation;

  template <class V>
  void Visit(V& v) {
    v("step", step);
    v("rate", rate);
    v("train_loss", train_loss);
    validation.Visit(v);
  }
};

/// The points of a training so far, in a file with comma-separated values and a line of names.
class Curves {
 public:
  /// Takes up the points up to `last_step` of a file, if it is there. Throws FileError.
  Curves(std::filesystem::path file, int last_step);

  /// Writes the file anew, atomically.
  void Append(const CurvePoint& point);
  const std::vector<CurvePoint>& points() const { return points_; }

 private:
  std::filesystem::path file_;
  std::vector<CurvePoint> points_;
};

/// The shares of right answers against steps.
Figure CurvesFigure(const std::vector<CurvePoint>& points);

}  // namespace bulletnav::bench
