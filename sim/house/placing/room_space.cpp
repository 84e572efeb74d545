// SPDX-License-Identifier: MIT
#include "sim/house/placing/room_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/shell/faces.h"

namespace bulletnav::sim::placing {
namespace {

constexpr float kWayWidth = 0.56f;     // kept free between pieces
constexpr float kOverHead = 1.7f;      // what hangs higher is in nobody's way, metres
constexpr float kFlat = 0.03f;         // what is lower is walked over
constexpr float kCasing = 0.09f;       // around holes in walls
constexpr float kAtWall = 0.25f;       // pieces this near a wall hide what is in it
constexpr float kPitEdge = 0.04f;      // beside a hole in the floor
constexpr float kHangs = 0.02f;        // pieces this near a wall hang on it
constexpr float kStandBefore = 0.32f;  // from a door to where one stands before it

Box Shrunk(const Box& box, float by) {
  return {box.min() + Eigen::Vector3f::Constant(by), box.max() - Eigen::Vector3f::Constant(by)};
}

/// The larger of `best` and the rectangles around p, q and the height of a corner that lie inside.
Rect LargestAround(const Room& room, const PlanPoint& p, const PlanPoint& q, Rect best) {
  for (const PlanPoint& r : room.outline) {
    Rect rect(p);
    rect.extend(q);
    rect.extend(PlanPoint(p.x(), r.y()));
    const float best_area = best.isEmpty() ? 0.0f : best.volume();
    if (rect.volume() > best_area && Contains(room.outline, rect)) best = rect;
  }
  return best;
}

/// The largest rectangle between coordinates of the outline.
Rect LargestRect(const Room& room) {
  Rect best;
  for (const PlanPoint& p : room.outline) {
    for (const PlanPoint& q : room.outline) best = LargestAround(room, p, q, best);
  }
  return best;
}

}  // namespace

Rect FootOf(const Box& box) {
  return {PlanPoint(box.min().x(), box.min().z()), PlanPoint(box.max().x(), box.max().z())};
}

RoomSpace::RoomSpace(const FloorPlan& plan, const HouseStyle& style, int room)
    : room_(plan.rooms[static_cast<std::size_t>(room)]),
      sides_(shell::SidesOf(plan, style, room)),
      ceiling_(plan.ceiling),
      main_floor_(LargestRect(room_)) {
  for (const shell::Side& side : sides_) {
    side_frames_.push_back(shell::FaceFrame(side.left, side.right));
  }
  for (const bool entry : {true, false}) {
    for (const Opening& opening : plan.openings) {
      const bool is_here = opening.room_a == room || opening.room_b == room;
      if (opening.IsPassage() && is_here && (opening.room_b < 0) == entry) AddDoor(plan, opening);
    }
  }
  for (const Pit& pit : plan.pits) {
    if (pit.room != room) continue;
    // Nothing stands on it or before its edge; lamps may hang over it.
    const PlanPoint edge = PlanPoint::Constant(kPitEdge);
    const PlanPoint low = pit.low() - edge;
    const PlanPoint high = pit.high() + edge;
    taken_.emplace_back(Eigen::Vector3f(low.x(), -pit.depth, low.y()),
                        Eigen::Vector3f(high.x(), kOverHead, high.y()));
    pits_.emplace_back(pit.low(), pit.high());
  }
  std::vector<Rect> leaves;
  for (const Box& leaf : taken_) leaves.push_back(FootOf(leaf));
  grid_.emplace(room_, mouths_, leaves, 0.5f * kWayWidth);
}

void RoomSpace::AddDoor(const FloorPlan& plan, const Opening& door) {
  const bool in_a = &plan.rooms[static_cast<std::size_t>(door.room_a)] == &room_;
  const PlanPoint along = (door.b - door.a).normalized();
  const PlanPoint inwards = in_a ? LeftOf(along) : PlanPoint(-LeftOf(along));
  const float to_face = 0.5f * door.wall_thickness;
  const PlanPoint middle = 0.5f * (door.a + door.b);
  mouths_.push_back(middle + (to_face + kStandBefore) * inwards);
  const bool swings_here = door.has_leaf && door.opens_into_a == in_a;
  const float depth = swings_here ? door.width() + 0.05f : 0.7f;
  Rect zone(PlanPoint(door.a - 0.1f * along));
  zone.extend(PlanPoint(door.b + 0.1f * along));
  zone.extend(PlanPoint(door.a - 0.1f * along + (to_face + depth) * inwards));
  if (swings_here) {
    Rect leaf;
    for (const PlanPoint& corner : LeafOutline(door)) leaf.extend(corner);
    zone.extend(leaf);
    taken_.emplace_back(Eigen::Vector3f(leaf.min().x(), 0.0f, leaf.min().y()),
                        Eigen::Vector3f(leaf.max().x(), door.top, leaf.max().y()));
  }
  doorways_.push_back(zone);
}

bool RoomSpace::MeetsPit(const Rect& rect) const {
  return std::any_of(pits_.begin(), pits_.end(), [&](const Rect& pit) {
    return pit.intersects(rect);
  });
}

bool RoomSpace::IsFree(const Box& box) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return other.intersects(box);
  });
}

bool RoomSpace::MeetsDoorway(const Rect& rect) const {
  return std::any_of(doorways_.begin(), doorways_.end(), [&](const Rect& zone) {
    return zone.intersects(rect);
  });
}

bool RoomSpace::MeetsClearance(const Rect& rect) const {
  return std::any_of(clearances_.begin(), clearances_.end(), [&](const Rect& zone) {
    return zone.intersects(rect);
  });
}

Box RoomSpace::SeenFrom(std::size_t side, const Box& box) const {
  Box seen;
  for (const auto corner : {Box::BottomLeftFloor, Box::TopRightCeil}) {
    seen.extend(side_frames_[side].inverse() * box.corner(corner));
  }
  return seen;
}

bool RoomSpace::HasWallBehind(const Box& box) const {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Box seen = SeenFrom(i, box);
    if (std::abs(seen.min().z()) > kHangs) continue;
    if (seen.min().x() >= 0.0f && seen.max().x() <= sides_[i].length()) return true;
  }
  return false;
}

bool RoomSpace::HidesOpening(const Box& box) const {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Box seen = SeenFrom(i, box);
    if (seen.min().z() > kAtWall || seen.max().z() < 0.0f) continue;
    for (const shell::Hole& hole : sides_[i].holes) {
      const bool beside = seen.max().x() < hole.x0 - kCasing || seen.min().x() > hole.x1 + kCasing;
      const bool below = seen.max().y() < hole.bottom - 0.02f;
      if (!beside && !below && seen.min().y() < hole.top + kCasing) return true;
    }
  }
  return false;
}

bool RoomSpace::LeavesWayPast(const Box& box) const {
  if (box.min().y() > kOverHead || box.max().y() < kFlat) return true;
  return grid_->StaysJoinedWith(FootOf(box));
}

void RoomSpace::Add(const Box& box, const std::optional<Rect>& clearance) {
  taken_.push_back(Shrunk(box, 0.004f));
  if (clearance) clearances_.push_back(*clearance);
  if (box.min().y() <= kOverHead && box.max().y() >= kFlat) grid_->Block(FootOf(box));
}

}  // namespace bulletnav::sim::placing
