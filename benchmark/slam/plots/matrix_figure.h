// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/report/figure.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// Pairs of a drive's frames as grey values, see SimilarityMatrix.
struct MatrixPanel {
  std::string title;
  sim::Image matrix;  // grey, square
};

/// Panels side by side, frame 0 at the upper left: the more alike two frames, the lighter. A place
/// seen again is a light line beside the diagonal, one passed the other way a line across it.
Figure MatrixFigure(const std::vector<MatrixPanel>& panels, int frames);

}  // namespace bulletnav::bench
