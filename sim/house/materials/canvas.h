// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "sim/house/materials/color.h"
#include "sim/image/image.h"

namespace bulletnav::sim::materials {

struct Box {
  Point low;
  Point high;
};

/// What happens to shapes that reach over the picture's edge.
enum class Edge { kWrap, kClip };

/// How a shape is laid on: opacity, and the width in which its edge fades (at least one pixel).
struct Coat {
  float alpha = 1.0f;
  float fade = 0.0f;
};

/// A square picture being made: shaded pixel by pixel, and painted over with shapes. A shape has
/// `Box Bounds() const` and `float Distance(Point) const`, negative inside, in fractions of the
/// side. A brush is a Color or a function from Point to Color. Edges of shapes are smoothed.
class Canvas {
 public:
  static constexpr int kSide = 256;

  /// `side` is a power of two.
  explicit Canvas(Color ground, Edge edge = Edge::kWrap, int side = kSide)
      : side_(side),
        edge_(edge),
        pixels_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), ground) {}

  /// Every pixel becomes shade(its centre) or shade(its centre, its colour).
  template <class F>
  void Shade(const F& shade) {
    const float step = 1.0f / static_cast<float>(side_);
    std::size_t i = 0;
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x, ++i) {
        const Point p = {(static_cast<float>(x) + 0.5f) * step,
                         (static_cast<float>(y) + 0.5f) * step};
        pixels_[i] = ShadeOf(shade, p, pixels_[i]);
      }
    }
  }

  template <class Shape, class Brush>
  void Paint(const Shape& shape, const Brush& brush, Coat coat = {}) {
    const float size = static_cast<float>(side_);
    const float fade = std::max(coat.fade, 1.0f / size);
    const Box box = shape.Bounds();
    const Span rows = Covered(box.low.y - fade, box.high.y + fade);
    const Span columns = Covered(box.low.x - fade, box.high.x + fade);
    for (int y = rows.begin; y < rows.end; ++y) {
      Color* row =
          &pixels_[static_cast<std::size_t>(y & (side_ - 1)) * static_cast<std::size_t>(side_)];
      for (int x = columns.begin; x < columns.end; ++x) {
        const Point p = {(static_cast<float>(x) + 0.5f) / size,
                         (static_cast<float>(y) + 0.5f) / size};
        const float cover = coat.alpha * Clamp01(0.5f - shape.Distance(p) / fade);
        if (cover <= 0.0f) continue;
        Color& pixel = row[x & (side_ - 1)];
        pixel = Mix(pixel, ColorOf(brush, p), cover);
      }
    }
  }

  /// The colour at a place, wrapped or clamped to the picture.
  Color At(Point p) const;

  /// Opaque RGBA.
  Image Finish() const;

 private:
  template <class F>
  static Color ShadeOf(const F& shade, Point p, Color old) {
    if constexpr (std::is_invocable_v<F, Point, Color>) {
      return shade(p, old);
    } else {
      return shade(p);
    }
  }

  template <class Brush>
  static Color ColorOf(const Brush& brush, Point p) {
    if constexpr (std::is_convertible_v<Brush, Color>) {
      return brush;
    } else {
      return brush(p);
    }
  }

  /// Pixels from `begin` to before `end` along one axis; beyond the picture where it wraps.
  struct Span {
    int begin = 0;
    int end = 0;
  };
  Span Covered(float low, float high) const {
    const Span all = {Floor(low * static_cast<float>(side_)),
                      Floor(high * static_cast<float>(side_)) + 1};
    if (edge_ == Edge::kWrap) return all;
    return {std::max(all.begin, 0), std::min(all.end, side_)};
  }

  int side_;
  Edge edge_;
  std::vector<Color> pixels_;
};

/// The picture of shade(point), which wraps if shade does.
template <class F>
Image Shaded(const F& shade, int side = Canvas::kSide) {
  Canvas canvas(Color{}, Edge::kWrap, side);
  canvas.Shade(shade);
  return canvas.Finish();
}

}  // namespace bulletnav::sim::materials
