// SPDX-License-Identifier: MIT
#include "sim/house/plan/review.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/plan/convex.h"

namespace bulletnav::sim::plan {
namespace {

constexpr float kDeadEnd = 2.1f;      // metres of corridor past the last opening
constexpr float kBesideLeaf = 0.35f;  // a wall nearer to an open leaf than this is taken

/// What furniture needs: one stretch of wall, beside which a window may be if its sill is not
/// lower.
struct WallNeed {
  RoomType type = RoomType::kLivingRoom;
  float length = 0.0f;
  float sill = 10.0f;
};

constexpr std::array kNeeds = {
    WallNeed{RoomType::kLivingRoom, 2.4f, 10.0f}, WallNeed{RoomType::kKitchen, 2.4f, 0.95f},
    WallNeed{RoomType::kBedroom, 2.1f, 0.7f},     WallNeed{RoomType::kKidsRoom, 2.0f, 0.7f},
    WallNeed{RoomType::kBathroom, 1.6f, 1.0f},    WallNeed{RoomType::kStudy, 1.6f, 0.7f},
    WallNeed{RoomType::kLaundry, 1.3f, 1.0f},     WallNeed{RoomType::kToilet, 0.9f, 1.0f},
};

struct Cut {
  float from = 0.0f;
  float to = 0.0f;
};

/// The part of edge p, q that a quad standing in front of it or on it covers.
void AddCut(const PlanPoint& p, const PlanPoint& q, const Quad& quad, std::vector<Cut>* cuts) {
  const PlanPoint along = (q - p).normalized();
  const PlanPoint across = LeftOf(along);
  const PlanPoint strip = kBesideLeaf * across;
  if (!AreClose(quad, {p - 0.1f * strip, q - 0.1f * strip, q + strip, p + strip}, 0.0f)) return;
  Cut cut{1e9f, -1e9f};
  for (const PlanPoint& corner : quad) {
    cut.from = std::min(cut.from, (corner - p).dot(along));
    cut.to = std::max(cut.to, (corner - p).dot(along));
  }
  cuts->push_back(cut);
}

float LongestGap(float length, std::vector<Cut> cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
    return a.from < b.from;
  });
  float longest = 0.0f;
  float at = 0.0f;
  for (const Cut& cut : cuts) {
    longest = std::max(longest, std::min(cut.from, length) - at);
    at = std::max(at, cut.to);
  }
  return std::max(longest, length - at);
}

float LongestFreeWall(const FloorPlan& plan, int room, float sill) {
  const auto& outline = plan.rooms[static_cast<std::size_t>(room)].outline;
  float longest = 0.0f;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint& p = outline[i];
    const PlanPoint& q = outline[(i + 1) % outline.size()];
    std::vector<Cut> cuts;
    for (const Opening& opening : plan.openings) {
      const bool is_mine = opening.room_a == room || opening.room_b == room;
      if (!is_mine || (!opening.IsPassage() && opening.bottom >= sill)) continue;
      AddCut(p, q, ApproachZone(opening, 0.02f), &cuts);
      if (opening.has_leaf) AddCut(p, q, LeafOutline(opening), &cuts);
    }
    longest = std::max(longest, LongestGap((q - p).norm(), cuts));
  }
  return longest;
}

/// Distance from a corridor's corner to the middle of its nearest door or arch.
float ToNearestPassage(const FloorPlan& plan, int room, const PlanPoint& corner) {
  float nearest = 1e9f;
  for (const Opening& opening : plan.openings) {
    const bool is_mine = opening.room_a == room || opening.room_b == room;
    if (!is_mine || !opening.IsPassage()) continue;
    nearest = std::min(nearest, (0.5f * (opening.a + opening.b) - corner).norm());
  }
  return nearest;
}

bool HasDeadEnd(const FloorPlan& plan, int room) {
  const auto& outline = plan.rooms[static_cast<std::size_t>(room)].outline;
  return std::any_of(outline.begin(), outline.end(), [&](const PlanPoint& corner) {
    return ToNearestPassage(plan, room, corner) > kDeadEnd;
  });
}

}  // namespace

bool IsLivable(const FloorPlan& plan) {
  for (int room = 0; room < static_cast<int>(plan.rooms.size()); ++room) {
    const RoomType type = plan.rooms[static_cast<std::size_t>(room)].type;
    if (type == RoomType::kCorridor && HasDeadEnd(plan, room)) return false;
    for (const WallNeed& need : kNeeds) {
      if (need.type == type && LongestFreeWall(plan, room, need.sill) < need.length) return false;
    }
  }
  return true;
}

}  // namespace bulletnav::sim::plan
