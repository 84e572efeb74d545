// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/image/image.h"

namespace bulletnav::bench {

/// Colour with opacity, all in [0, 1].
struct Paint {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double alpha = 1.0;

  constexpr Paint WithAlpha(double opacity) const { return {red, green, blue, opacity}; }
};

inline constexpr Paint kWhite = {1.0, 1.0, 1.0};

/// How a line is drawn.
struct Stroke {
  double width = 1.0;
  Paint paint;
  std::vector<double> dashes;  // lengths on, off, on, ...; empty: solid
};

enum class Align { kLeft, kCenter, kRight };

struct TextStyle {
  double size = 13.0;
  Paint paint;
  bool bold = false;
  Align align = Align::kCenter;
  bool halo = false;     // a soft white rim, so that it reads on any ground
  bool upwards = false;  // turned a quarter to the left
};

/// A picture drawn with cairo in units of pixels, y down: either pixels, at any scale, or vectors.
/// Text is drawn as outlines. The same calls give the same bytes.
class Canvas {
 public:
  using Point = Eigen::Vector2d;
  enum class Kind { kPixels, kSvg };

  Canvas(int width, int height, const Paint& background, Kind kind = Kind::kPixels,
         double scale = 1.0);
  /// Starts from an RGB picture.
  explicit Canvas(const sim::Image& image);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  Canvas(Canvas&&) = delete;
  Canvas& operator=(Canvas&&) = delete;

  void Fill(std::span<const Point> polygon, const Paint& paint);
  void Line(const Point& a, const Point& b, double width, const Paint& paint);
  void Polyline(std::span<const Point> points, const Stroke& stroke);
  void Outline(std::span<const Point> polygon, const Stroke& stroke);
  void Disc(const Point& centre, double radius, const Paint& paint);
  void Ring(const Point& centre, double radius, const Stroke& stroke);
  /// Many triangles in one go, without seams between them.
  void FillTriangles(std::span<const Point> corners, const Paint& paint);
  /// An RGB or RGBA picture, smoothed if wanted: `place` maps its pixels to the canvas.
  void Picture(const sim::Image& image, const Eigen::Affine2d& place, bool smooth);
  /// Everything until Unclip is drawn only within the box.
  void Clip(const Eigen::AlignedBox2d& box);
  void Unclip();

  /// Width and height of the ink of a text.
  Point TextSize(const std::string& text, double size, bool bold = true) const;
  /// `at`: the middle of its capitals' height; in width as style.align says.
  void Text(const Point& at, const std::string& text, const TextStyle& style);
  /// Bold, centred, with a halo.
  void Text(const Point& at, const std::string& text, double size, const Paint& paint);

  /// The picture so far, RGB. Expects: kPixels (checked).
  sim::Image ToImage() const;
  /// Ends the picture. Expects: kSvg (checked), and called once.
  std::string ToSvg();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bulletnav::bench
