// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/render/renderer.h"

namespace bulletnav::tests {

/// One picture of any camera.
struct Panorama {
  int rows = 0;
  int cols = 0;
  std::vector<std::uint8_t> color;
  std::vector<float> depth;

  float depth_at(int row, int col) const { return depth[index(row, col)]; }
  sim::Rgb8 color_at(int row, int col) const {
    const std::uint8_t* p = &color[3 * index(row, col)];
    return {p[0], p[1], p[2]};
  }
  std::size_t index(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(col);
  }
};

/// Unit direction of a pixel's ray in the world, by the definitions in projection.h, not by
/// RayGrid.
Eigen::Vector3f RayDirection(const sim::CameraSpec& spec, int row, int col, float yaw);

Panorama RenderPanorama(const sim::RenderScene& scene, const sim::CameraSpec& spec,
                        const sim::CameraPose& camera);

/// How well two renderers agree over some pictures: depth within 1 cm or 1% at pixels away from
/// depth edges, colour within 8 of 255 at all pixels.
class Agreement {
 public:
  void Add(const Panorama& a, const Panorama& b);
  double depth() const { return good_depth_ / static_cast<double>(depth_pixels_); }
  double color() const { return good_color_ / static_cast<double>(color_pixels_); }

 private:
  double good_depth_ = 0;
  double good_color_ = 0;
  std::size_t depth_pixels_ = 0;
  std::size_t color_pixels_ = 0;
};

}  // namespace bulletnav::tests
