// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::agent {

/// How a metric map is made. Metres. Defaults: Active Neural SLAM's.
struct MapSpec {
  double cell = 0.05;
  double size = 24.0;          // of a side; the map moves along with a body that nears its edge
  double vision = 3.2;         // farther points are not mapped
  double obstacle_low = 0.25;  // points between these heights are in the body's way
  double obstacle_high = 1.5;
  double drop = 0.25;  // floor deeper by this than the floor before it is not stepped down to; ours
  int obstacle_points = 2;  // pixels on a cell that make it an obstacle
  int dilation_cells = 1;   // obstacles grow by this for planning
  int clearance_cells = 2;  // ways avoid cells nearer to obstacles than this more; ours

  template <class V>
  void Visit(V& v) {
    v("cell", cell);
    v("size", size);
    v("vision", vision);
    v("obstacle_low", obstacle_low);
    v("obstacle_high", obstacle_high);
    v("drop", drop);
    v("obstacle_points", obstacle_points);
    v("dilation_cells", dilation_cells);
    v("clearance_cells", clearance_cells);
  }
  void Validate() const {
    if (!(cell >= 0.01 && vision >= 2.0 * cell)) {
      throw sim::Error("a map needs cells of at least 0.01 m and a vision of at least two cells");
    }
    if (!(size >= 4.0 * vision && size / cell <= 4096.0)) {
      throw sim::Error("the map's size must be at least 4 times its vision and at most 4096 cells");
    }
    if (!(obstacle_low < obstacle_high)) {
      throw sim::Error("obstacle_low must lie below obstacle_high");
    }
    if (!(drop > 0.0)) throw sim::Error("a map's drop must be positive");
    const int grown = dilation_cells + clearance_cells;
    if (obstacle_points < 1 || dilation_cells < 0 || clearance_cells < 0 || grown > 20) {
      throw sim::Error("expected obstacle_points >= 1 and dilation_cells, clearance_cells >= 0");
    }
  }
  int cells() const { return static_cast<int>(std::lround(size / cell)); }
};

}  // namespace bulletnav::agent
