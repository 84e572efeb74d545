// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

namespace bulletnav::tests {

/// Shortest way between two points of the plane over free cells, by Dijkstra with 32 directions on
/// a grid of `cell` metres over [0, width] x [0, depth]: at most 1% longer than the true one, plus
/// a cell. Negative if there is none. A slow, simple oracle for geodesics.
double GridPathLength(double width, double depth, double cell,
                      const std::function<bool(double x, double y)>& is_free, double from_x,
                      double from_y, double to_x, double to_y);

}  // namespace bulletnav::tests
