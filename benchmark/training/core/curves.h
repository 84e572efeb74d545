// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/report/figure.h"
#include "benchmark/training/core/train_task.h"

namespace bulletnav::bench {

/// What a training writes down at each validation.
struct CurvePoint {
  int step = 0;
  double rate = 0.0;
  double train_loss = 0.0;  // mean since the last point
  Measures validation;
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

/// Some of the measures against steps.
Figure CurvesFigure(const std::vector<CurvePoint>& points, const std::vector<CurveLine>& lines,
                    const std::string& label);

}  // namespace bulletnav::bench
