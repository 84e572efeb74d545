// SPDX-License-Identifier: MIT
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {
namespace {

Box Around(Point centre, float reach) {
  return {centre - Point{reach, reach}, centre + Point{reach, reach}};
}

float Inverse(float square) {
  return square > 0.0f ? 1.0f / square : 0.0f;
}

}  // namespace

Box Ellipse::Bounds() const {
  return Around(centre_, std::max(radii_.x, radii_.y));
}

Box Ring::Bounds() const {
  return Around(centre_, radius_ + half_);
}

Box Rect::Bounds() const {
  if (axis.y == 0.0f) return {low, high};
  return Around((low + high) * 0.5f, 0.5f * Length(high - low));
}

Stroke::Stroke(Point a, Point b, float width)
    : a_(a), along_(b - a), inverse_square_(Inverse(Dot(along_, along_))), half_(0.5f * width) {}

Box Stroke::Bounds() const {
  const Point b = a_ + along_;
  return {{std::min(a_.x, b.x) - half_, std::min(a_.y, b.y) - half_},
          {std::max(a_.x, b.x) + half_, std::max(a_.y, b.y) + half_}};
}

Leaf::Leaf(Point root, Point tip, float width)
    : middle_((root + tip) * 0.5f),
      unit_((tip - root) * (1.0f / Length(tip - root))),
      reach_(0.5f * Length(tip - root)),
      half_(0.5f * width),
      radius_((reach_ * reach_ + half_ * half_) / width) {}

Box Leaf::Bounds() const {
  return Stroke(middle_ - unit_ * reach_, middle_ + unit_ * reach_, 2.0f * half_).Bounds();
}

Polygon::Polygon(std::span<const Point> corners) : bounds_{corners.front(), corners.front()} {
  Point from = corners.back();
  for (const Point& corner : corners) {
    const Point along = corner - from;
    const float square = Dot(along, along);
    sides_.push_back({from, along, Inverse(square), along.y != 0.0f ? along.x / along.y : 0.0f});
    bounds_.low = {std::min(bounds_.low.x, corner.x), std::min(bounds_.low.y, corner.y)};
    bounds_.high = {std::max(bounds_.high.x, corner.x), std::max(bounds_.high.y, corner.y)};
    from = corner;
  }
}

float Polygon::Distance(Point p) const {
  float nearest = 1e9f;
  bool inside = false;
  for (const Side& side : sides_) {
    const Point q = p - side.from;
    const Point off = q - side.along * Clamp01(Dot(q, side.along) * side.inverse_square);
    nearest = std::min(nearest, Dot(off, off));
    // Does a ray to the right cross this side?
    if ((q.y < 0.0f) != (q.y < side.along.y) && q.x < q.y * side.slope) inside = !inside;
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

Polygon Star(Point centre, int points, Point inner_outer, float angle) {
  std::vector<Point> corners;
  for (int i = 0; i < 2 * points; ++i) {
    const float radius = i % 2 == 0 ? inner_outer.y : inner_outer.x;
    const float turn = angle + kPi * static_cast<float>(i) / static_cast<float>(points);
    corners.push_back(centre + Turned({0.0f, -radius}, turn));
  }
  return Polygon(corners);
}

}  // namespace bulletnav::sim::materials
