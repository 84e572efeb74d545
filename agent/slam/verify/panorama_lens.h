// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include <Eigen/Core>

#include "sim/base/elementary.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// A place in a picture, in pixels, the centre of the first one at 0, 0, and how far away it is.
struct PicturePoint {
  double col = 0.0;
  double row = 0.0;
  double level_m = 0.0;  // from the camera, level; of a pinhole's picture along its axis
};

/// A whole cylindrical panorama of a level camera (sim::Projection::kCylindrical): columns go
/// clockwise by equal angles, rows are linear in the tangent of elevation. Points are seen from the
/// body: metres ahead, to the left, up from the camera.
struct PanoramaLens {
  double first_bearing = sim::kPi;  // radians to the left of ahead, of column 0
  double column = 0.0;              // radians to the right, a column
  double first_slope = 1.0;         // metres up for each metre of level distance, of row 0
  double row = 0.0;                 // the same down, a row

  /// Of a picture of this size that reaches 45 degrees up and down.
  static PanoramaLens Of(int rows, int cols) {
    const double column = 2.0 * sim::kPi / cols;
    const double row = 2.0 / rows;
    return {sim::kPi - column / 2.0, column, 1.0 - row / 2.0, row};
  }

  Eigen::Vector3d PointAt(const PicturePoint& place) const {
    const double bearing = first_bearing - place.col * column;
    return place.level_m *
           Eigen::Vector3d(sim::Cos(bearing), sim::Sin(bearing), first_slope - place.row * row);
  }
  /// Columns from -0.5 on and less than a whole turn. Expects: a point that is not above or below
  /// the camera.
  PicturePoint PlaceOf(const Eigen::Vector3d& point) const {
    const double level = std::hypot(point.x(), point.y());
    const double turn = 2.0 * sim::kPi / column;
    double col = (first_bearing - sim::Atan2(point.y(), point.x())) / column;
    if (col < -0.5) col += turn;
    if (col >= turn - 0.5) col -= turn;
    return {col, (first_slope - point.z() / level) / row, level};
  }
  /// Of the picture that has every n-th pixel of this one's, from an offset on.
  PanoramaLens Every(int n, int col_offset, int row_offset) const {
    return {first_bearing - col_offset * column, n * column, first_slope - row_offset * row,
            n * row};
  }
};

}  // namespace bulletnav::agent
