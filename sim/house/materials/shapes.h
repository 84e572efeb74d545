// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <span>
#include <vector>

#include "sim/house/materials/canvas.h"

namespace bulletnav::sim::materials {

// Shapes for Canvas::Paint. Lengths in fractions of the picture's side, angles in radians,
// clockwise as seen. What every pixel needs is worked out when a shape is made.

class Ellipse {
 public:
  Ellipse(Point centre, Point radii, float angle = 0.0f)
      : centre_(centre), radii_(radii), axis_(Turned({1.0f, 0.0f}, angle)) {}
  Box Bounds() const;
  float Distance(Point p) const {
    const Point q = AlongAxis(p - centre_, axis_);
    const Point scaled = {q.x / radii_.x, q.y / radii_.y};
    const float k = Length(scaled);
    if (k < 1e-6f) return -std::min(radii_.x, radii_.y);
    // First-order distance: exact on the outline, good near it, which is all that smoothing needs.
    return k * (k - 1.0f) / Length({scaled.x / radii_.x, scaled.y / radii_.y});
  }

 private:
  Point centre_;
  Point radii_;
  Point axis_;
};

inline Ellipse Disc(Point centre, float radius) {
  return {centre, {radius, radius}};
}

/// Outline of a circle, `width` wide.
class Ring {
 public:
  Ring(Point centre, float radius, float width)
      : centre_(centre), radius_(radius), half_(0.5f * width) {}
  Box Bounds() const;
  float Distance(Point p) const { return std::abs(Length(p - centre_) - radius_) - half_; }

 private:
  Point centre_;
  float radius_;
  float half_;
};

/// Rectangle, its corners rounded by `rounding`, turned about its centre.
struct Rect {
  Rect(Point low_corner, Point high_corner, float corner_radius = 0.0f, float angle = 0.0f)
      : low(low_corner),
        high(high_corner),
        rounding(corner_radius),
        axis(Turned({1.0f, 0.0f}, angle)) {}
  Box Bounds() const;
  float Distance(Point p) const {
    const Point q = AlongAxis(p - (low + high) * 0.5f, axis);
    const float dx = std::abs(q.x) - 0.5f * (high.x - low.x) + rounding;
    const float dy = std::abs(q.y) - 0.5f * (high.y - low.y) + rounding;
    const float inside = std::min(std::max(dx, dy), 0.0f) - rounding;
    return dx > 0.0f && dy > 0.0f ? Length({dx, dy}) - rounding
                                  : std::max(std::max(dx, dy), 0.0f) + inside;
  }

  Point low;
  Point high;
  float rounding;
  Point axis;
};

/// Straight stroke with round ends.
class Stroke {
 public:
  Stroke(Point a, Point b, float width);
  Box Bounds() const;
  float Distance(Point p) const {
    const Point q = p - a_;
    return Length(q - along_ * Clamp01(Dot(q, along_) * inverse_square_)) - half_;
  }

 private:
  Point a_;
  Point along_;
  float inverse_square_;  // 1 / squared length, 0 if it has none
  float half_;
};

/// Leaf or petal: two arcs from `root` to `tip`, `width` across the middle.
class Leaf {
 public:
  Leaf(Point root, Point tip, float width);
  Box Bounds() const;
  float Distance(Point p) const {
    const Point q = p - middle_;
    const float across = std::abs(q.x * unit_.y - q.y * unit_.x);
    return Length({across + radius_ - half_, Dot(q, unit_)}) - radius_;
  }

 private:
  Point middle_;
  Point unit_;    // from root to tip
  float reach_;   // from the middle to a tip
  float half_;    // of the width
  float radius_;  // of the arcs; their centres lie radius - half beyond the midrib
};

/// Any simple polygon.
class Polygon {
 public:
  explicit Polygon(std::span<const Point> corners);
  Polygon(std::initializer_list<Point> corners)
      : Polygon(std::span<const Point>(corners.begin(), corners.size())) {}
  Box Bounds() const { return bounds_; }
  float Distance(Point p) const;

 private:
  struct Side {
    Point from;
    Point along;
    float inverse_square = 0.0f;
    float slope = 0.0f;  // change of x with y
  };
  std::vector<Side> sides_;
  Box bounds_;
};

/// Star with `points` tips at `outer` and notches at `inner`, the first tip at `angle` from up.
Polygon Star(Point centre, int points, Point inner_outer, float angle = 0.0f);

}  // namespace bulletnav::sim::materials
