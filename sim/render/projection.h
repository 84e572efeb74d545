// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// How a panorama's rows and columns map to directions. In all of them column 0 looks 180 degrees
/// behind, columns go clockwise seen from above, and the middle of the picture looks forward.
/// kCylindrical: equal angle a column, rows linear in tan(elevation), +-45 degrees.
/// kEquirectangular: equal angle a column and a row, +-90 degrees.
/// kCubeStrip: four square 90-degree views side by side, their centres at -135, -45, 45 and 135
/// degrees clockwise from forward.
enum class Projection { kCylindrical, kEquirectangular, kCubeStrip };

template <>
struct EnumNames<Projection> {
  static constexpr std::array kNames = {std::pair{"cylindrical", Projection::kCylindrical},
                                        std::pair{"equirectangular", Projection::kEquirectangular},
                                        std::pair{"cube_strip", Projection::kCubeStrip}};
};

/// What a panorama looks like. Defaults: Neural Topological SLAM, section 5 (128 x 512).
struct PanoramaSpec {
  int rows = 128;
  int cols = 512;
  Projection projection = Projection::kCylindrical;
  float max_depth_m = 10.0f;  // depth is clipped here

  std::size_t pixels() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  }
  template <class V>
  void Visit(V& v) {
    v("rows", rows);
    v("cols", cols);
    v("projection", projection);
    v("max_depth_m", max_depth_m);
  }
  /// Throws Error for a size outside 8 x 16 to 4096 x 16384, a cube strip whose width is not a
  /// multiple of 4, or a depth limit that is not positive.
  void Validate() const;
};

/// Ray directions of every pixel centre for a camera that looks along -z, not normalised:
/// d(row, col) = (x[col], y[row], z[col]). All three projections have this form, because a
/// direction may be scaled freely; hypot(x, z) is 1 but for cube strips (up to sqrt 2).
struct RayGrid {
  explicit RayGrid(const PanoramaSpec& spec);

  std::vector<float> x;  // [cols]
  std::vector<float> z;  // [cols]
  std::vector<float> y;  // [rows], from the top, falling
  /// [rows]; a pixel's footprint on a surface it meets at parameter t is area[row] * t^2 / |n.d|
  /// m2, n the unit normal.
  std::vector<float> area;
};

}  // namespace bulletnav::sim
