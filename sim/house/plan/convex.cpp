// SPDX-License-Identifier: MIT
#include "sim/house/plan/convex.h"

#include <algorithm>

namespace bulletnav::sim::plan {
namespace {

struct Range {
  float low = 1e30f;
  float high = -1e30f;
};

Range Project(const Quad& quad, const PlanPoint& axis) {
  Range range;
  for (const PlanPoint& p : quad) {
    range.low = std::min(range.low, p.dot(axis));
    range.high = std::max(range.high, p.dot(axis));
  }
  return range;
}

bool IsSeparatedAlongSides(const Quad& sides, const Quad& other, float gap) {
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanPoint side = sides[(i + 1) % 4] - sides[i];
    if (side.squaredNorm() < 1e-12f) continue;
    const PlanPoint axis = LeftOf(side.normalized());
    const Range a = Project(sides, axis);
    const Range b = Project(other, axis);
    if (a.high + gap < b.low || b.high + gap < a.low) return true;
  }
  return false;
}

}  // namespace

bool AreClose(const Quad& a, const Quad& b, float gap) {
  return !IsSeparatedAlongSides(a, b, gap) && !IsSeparatedAlongSides(b, a, gap);
}

Quad ApproachZone(const Opening& opening, float reach) {
  const PlanPoint out =
      LeftOf((opening.b - opening.a).normalized()) * (0.5f * opening.wall_thickness + reach);
  return {opening.a + out, opening.b + out, opening.b - out, opening.a - out};
}

}  // namespace bulletnav::sim::plan
