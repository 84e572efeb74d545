// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

#include "sim/image/image.h"

namespace bulletnav::bench {

/// Colour with opacity, all in [0, 1].
struct Paint {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double alpha = 1.0;
};

/// A picture drawn with cairo in pixels, y down.
class Canvas {
 public:
  using Point = Eigen::Vector2d;

  Canvas(int width, int height, const Paint& background);
  /// Starts from an RGB picture.
  explicit Canvas(const sim::Image& image);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  Canvas(Canvas&&) = delete;
  Canvas& operator=(Canvas&&) = delete;

  void Fill(std::span<const Point> polygon, const Paint& paint);
  void Line(const Point& a, const Point& b, double width, const Paint& paint);
  /// Many triangles in one go, without seams between them.
  void FillTriangles(std::span<const Point> corners, const Paint& paint);
  /// Width and height of the ink of a text.
  Point TextSize(const std::string& text, double size) const;
  /// Centred on `at`; drawn over a soft halo so that it reads on any ground.
  void Text(const Point& at, const std::string& text, double size, const Paint& paint);

  /// The picture so far, RGB.
  sim::Image ToImage() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bulletnav::bench
