// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/shell/room_shell.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kOnLine = 0.005f;  // metres

/// The opening as a hole in the side from `left` to `right`, if it is in that wall.
void AddHole(const Opening& opening, bool is_cased, Side* side) {
  const PlanPoint along = (side->right - side->left).normalized();
  const PlanPoint to_a = opening.a - side->left;
  const float behind = std::abs(to_a.dot(LeftOf(along)));
  if (std::abs(behind - 0.5f * opening.wall_thickness) > kOnLine) return;
  const float s = to_a.dot(along);
  const float t = (opening.b - side->left).dot(along);
  const float x0 = std::min(s, t);
  const float x1 = std::max(s, t);
  if (x0 < 0.0f || x1 > side->length() || x1 - x0 < 0.5f * opening.width()) return;
  const float bottom = opening.IsPassage() ? -1.0f : opening.bottom;
  side->holes.push_back({x0, x1, bottom, opening.top, is_cased});
}

bool IsHollow(const PlanPoint& before, const PlanPoint& corner, const PlanPoint& after) {
  // The room is to the left: a turn to the left makes an inner corner.
  return LeftOf(corner - before).dot(after - corner) > 0.0f;
}

}  // namespace

std::vector<Side> SidesOf(const FloorPlan& plan, const HouseStyle& style, int room) {
  const auto& outline = plan.rooms[static_cast<std::size_t>(room)].outline;
  const std::size_t n = outline.size();
  std::vector<Side> sides;
  for (std::size_t i = 0; i < n; ++i) {
    const PlanPoint& p = outline[i];
    const PlanPoint& q = outline[(i + 1) % n];
    Side side{static_cast<int>(i),
              q,
              p,
              IsHollow(p, q, outline[(i + 2) % n]),
              IsHollow(outline[(i + n - 1) % n], p, q),
              {}};
    for (const Opening& opening : plan.openings) {
      if (opening.room_a != room && opening.room_b != room) continue;
      const bool is_cased = opening.kind == OpeningKind::kDoor ||
                            (opening.kind == OpeningKind::kArch && style.has_cased_arches);
      AddHole(opening, is_cased, &side);
    }
    std::sort(side.holes.begin(), side.holes.end(), [](const Hole& a, const Hole& b) {
      return a.x0 < b.x0;
    });
    sides.push_back(std::move(side));
  }
  return sides;
}

}  // namespace bulletnav::sim::shell
