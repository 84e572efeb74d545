// SPDX-License-Identifier: MIT
#include "sim/render/projection.h"

#include <cmath>

#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

constexpr int kMinRows = 8;
constexpr int kMaxRows = 4096;
constexpr int kMinCols = 16;
constexpr int kMaxCols = 16384;

/// Columns of equal angle, clockwise from behind.
void FillCircle(RayGrid* grid, int cols) {
  for (int c = 0; c < cols; ++c) {
    const double clockwise = 2.0 * kPi * (c + 0.5) / cols - kPi;
    grid->x.push_back(static_cast<float>(std::sin(clockwise)));
    grid->z.push_back(static_cast<float>(-std::cos(clockwise)));
  }
}

/// Columns of four flat views; those of one view lie on a line at distance 1.
void FillCubeSides(RayGrid* grid, int cols) {
  const int side = cols / 4;
  for (int c = 0; c < cols; ++c) {
    const double centre = (c / side - 1.5) * 0.5 * kPi;
    const double across = 2.0 * (c % side + 0.5) / side - 1.0;
    grid->x.push_back(static_cast<float>(std::sin(centre) + across * std::cos(centre)));
    grid->z.push_back(static_cast<float>(-std::cos(centre) + across * std::sin(centre)));
  }
}

/// Rows linear in y, from +1 to -1. `column` is the width of a column at distance 1.
void FillLinearRows(RayGrid* grid, int rows, double column) {
  for (int r = 0; r < rows; ++r) {
    grid->y.push_back(static_cast<float>(1.0 - 2.0 * (r + 0.5) / rows));
    grid->area.push_back(static_cast<float>(column * 2.0 / rows));
  }
}

/// Rows of equal angle, from zenith to nadir.
void FillAngularRows(RayGrid* grid, int rows, double column) {
  for (int r = 0; r < rows; ++r) {
    const double elevation = 0.5 * kPi - kPi * (r + 0.5) / rows;
    const double cosine = std::cos(elevation);
    grid->y.push_back(static_cast<float>(std::tan(elevation)));
    grid->area.push_back(static_cast<float>(column * kPi / rows / (cosine * cosine)));
  }
}

}  // namespace

void PanoramaSpec::Validate() const {
  if (rows < kMinRows || rows > kMaxRows || cols < kMinCols || cols > kMaxCols) {
    throw Error("a panorama of " + std::to_string(cols) + "x" + std::to_string(rows) +
                " cannot be drawn; sizes go from 16x8 to 16384x4096");
  }
  if (projection == Projection::kCubeStrip && cols % 4 != 0) {
    throw Error("the width of a cube strip must be a multiple of 4");
  }
  if (!(max_depth_m > 0.0f)) throw Error("max_depth_m must be positive");
}

RayGrid::RayGrid(const PanoramaSpec& spec) {
  spec.Validate();
  const double angle = 2.0 * kPi / spec.cols;
  switch (spec.projection) {
    case Projection::kCylindrical:
      FillCircle(this, spec.cols);
      FillLinearRows(this, spec.rows, angle);
      return;
    case Projection::kEquirectangular:
      FillCircle(this, spec.cols);
      FillAngularRows(this, spec.rows, angle);
      return;
    case Projection::kCubeStrip:
      FillCubeSides(this, spec.cols);
      FillLinearRows(this, spec.rows, 8.0 / spec.cols);
      return;
  }
}

}  // namespace bulletnav::sim
