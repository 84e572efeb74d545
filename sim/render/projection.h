// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <variant>
#include <vector>

#include <Eigen/Core>

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

/// What a pinhole camera sees: a flat picture whose middle looks forward, turned up by pitch_deg.
/// Pixels are square, so that the vertical field of view follows from the size. Column 0 is on the
/// left, row 0 above. Default: the camera of Active Neural SLAM in a larger picture.
struct PinholeSpec {
  double hfov_deg = 90.0;  // horizontal field of view
  int rows = 480;
  int cols = 640;
  double pitch_deg = 0.0;     // positive looks up
  float max_depth_m = 10.0f;  // depth is clipped here; it is range along the ray, as in panoramas

  std::size_t pixels() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  }
  template <class V>
  void Visit(V& v) {
    v("hfov_deg", hfov_deg);
    v("rows", rows);
    v("cols", cols);
    v("pitch_deg", pitch_deg);
    v("max_depth_m", max_depth_m);
  }
  /// Half extents of the picture at distance 1.
  double tan_x() const;
  double tan_y() const { return tan_x() * rows / cols; }
  /// Throws Error for a size outside 8 x 16 to 4096 x 16384, a field of view outside 5 to 150
  /// degrees, across or upwards, a pitch beyond straight up or down, or a depth limit that is not
  /// positive.
  void Validate() const;
};

/// Any camera that can be drawn.
using CameraSpec = std::variant<PanoramaSpec, PinholeSpec>;

struct PictureSize {
  int rows = 0;
  int cols = 0;
  std::size_t pixels() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  }
};
PictureSize SizeOf(const CameraSpec& spec);
float MaxDepthOf(const CameraSpec& spec);

/// Ray directions of every pixel centre for a camera that looks along -z, not normalised:
/// d(row, col) = (x[col], y[row], z[col]), then turned up by `pitch`. All projections have this
/// form, because a direction may be scaled freely; hypot(x, z) is 1 in panoramas, but for cube
/// strips (up to sqrt 2), and 1 / cos of the angle from the middle column in pinhole pictures.
struct RayGrid {
  /// Throws Error on a bad spec.
  explicit RayGrid(const CameraSpec& spec);

  /// Of a pixel, pitch included.
  Eigen::Vector3f Direction(std::size_t row, std::size_t col) const;

  std::vector<float> x;  // [cols]
  std::vector<float> z;  // [cols]
  std::vector<float> y;  // [rows], from the top, falling
  /// [rows]; a pixel's footprint on a surface it meets at parameter t is area[row] * t^2 / |n.d|
  /// m2, n the unit normal.
  std::vector<float> area;
  double pitch = 0.0;  // radians, positive looks up
};

}  // namespace bulletnav::sim
