// SPDX-License-Identifier: MIT
#include "sim/house/floor_plan.h"

#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::sim {

float PolygonArea(std::span<const PlanPoint> outline) {
  float twice = 0.0f;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint& p = outline[i];
    const PlanPoint& q = outline[(i + 1) % outline.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5f * std::abs(twice);
}

bool IsInside(std::span<const PlanPoint> outline, const PlanPoint& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint& p = outline[i];
    const PlanPoint& q = outline[(i + 1) % outline.size()];
    if ((p.y() > point.y()) == (q.y() > point.y())) continue;
    const float x = p.x() + (q.x() - p.x()) * (point.y() - p.y()) / (q.y() - p.y());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

std::array<PlanPoint, 4> LeafOutline(const Opening& door) {
  BULLETNAV_CHECK(door.has_leaf);
  const PlanPoint& hinge_jamb = door.hinge_at_a ? door.a : door.b;
  const PlanPoint& free_jamb = door.hinge_at_a ? door.b : door.a;
  const PlanPoint along = (free_jamb - hinge_jamb).normalized();
  const PlanPoint to_a = LeftOf((door.b - door.a).normalized());
  const PlanPoint swing = door.opens_into_a ? to_a : PlanPoint(-to_a);
  const PlanPoint hinge = hinge_jamb + 0.5f * door.wall_thickness * swing;
  const float c = Cos(door.door_angle);
  const float s = Sin(door.door_angle);
  const PlanPoint leaf = c * along + s * swing;
  const PlanPoint back = kLeafThickness * (s * along - c * swing);
  const PlanPoint tip = hinge + door.width() * leaf;
  return {hinge, tip, tip + back, hinge + back};
}

std::array<PlanPoint, 4> Pit::Outline() const {
  const PlanPoint aside = width * across;
  const PlanPoint far = length * into;
  return {corner, corner + aside, corner + aside + far, corner + far};
}

float FloorPlan::area() const {
  float sum = 0.0f;
  for (const Room& room : rooms) sum += room.area();
  return sum;
}

}  // namespace bulletnav::sim
