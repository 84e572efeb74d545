// SPDX-License-Identifier: MIT
#include "sim/house/building/stairwell.h"

#include <algorithm>
#include <array>
#include <optional>

#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

constexpr float kFromWall = 0.02f;    // a pit's edge at a wall; baseboards stand on what is left
constexpr float kBeforeDoor = 0.95f;  // floor kept before doors
constexpr float kWay = 1.0f;          // floor kept beside a pit
constexpr float kLeastDrop = 0.45f;   // down to a first step that no body walks onto
constexpr float kLargeRoom = 45.0f;   // m2
constexpr int kTries = 24;

/// A room's rectangle seen from one of its sides.
struct Seen {
  PlanPoint corner;
  PlanPoint into;
  PlanPoint across;
  float length;
  float width;
};

Seen SeenFrom(const Room& room, int side) {
  PlanPoint low = room.outline.front();
  PlanPoint high = low;
  for (const PlanPoint& p : room.outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const PlanPoint size = high - low;
  switch (side) {
    case 0:
      return {low, {0, 1}, {1, 0}, size.y(), size.x()};
    case 1:
      return {high, {0, -1}, {-1, 0}, size.y(), size.x()};
    case 2:
      return {{low.x(), high.y()}, {1, 0}, {0, -1}, size.x(), size.y()};
    default:
      return {{high.x(), low.y()}, {-1, 0}, {0, 1}, size.x(), size.y()};
  }
}

/// Whether floor is left before all doors of the pit's room and the pit lies in it.
bool IsClearOfDoors(const FloorPlan& plan, const Pit& pit) {
  const Eigen::AlignedBox2f box(pit.low(), pit.high());
  for (const Opening& opening : plan.openings) {
    if (!opening.IsPassage() || (opening.room_a != pit.room && opening.room_b != pit.room)) {
      continue;
    }
    const float keep = kBeforeDoor + 0.5f * opening.wall_thickness;
    for (const float t : {0.0f, 0.5f, 1.0f}) {
      if (box.exteriorDistance(opening.a + t * (opening.b - opening.a)) < keep) return false;
    }
  }
  return true;
}

/// Moves a pit's corner within what is seen of its room.
void PutAt(const Seen& seen, float x, float z, Pit* pit) {
  pit->corner = seen.corner + x * seen.across + z * seen.into;
  pit->into = seen.into;
  pit->across = seen.across;
}

/// Rails at free edges: all (with a chance), some or none. Edges at walls are not free.
void DrawRails(const std::array<bool, 4>& is_free, double all, Rng* rng, Pit* pit) {
  static constexpr std::array kRails = {Rail::kBars, Rail::kBars, Rail::kGlass, Rail::kBoards};
  pit->rail = rng->Pick(kRails);
  const double share = rng->Chance(all) ? 1.0 : (rng->Chance(0.35) ? 0.5 : 0.0);
  for (std::size_t i = 0; i < 4; ++i) pit->rails[i] = is_free[i] && rng->Chance(share);
}

/// A stair takes the far part of the room, from wall to wall or with a way beside it.
std::optional<Pit> DrawStair(const FloorPlan& plan, int room, Rng* rng) {
  const Seen seen = SeenFrom(plan.rooms[static_cast<std::size_t>(room)], rng->Below(4));
  Pit pit;
  pit.room = room;
  const float front = Draw(rng, 1.1, 1.8);
  pit.length = std::min(seen.length - front - kFromWall, Draw(rng, 2.4, 5.5));
  const bool has_way = seen.width > 1.3f + kWay && rng->Chance(0.5);
  pit.width = seen.width - (has_way ? Draw(rng, 1.0, 1.5) + kFromWall : 2.0f * kFromWall);
  pit.width = std::min(pit.width, 3.2f);
  if (pit.length < 1.3f || pit.width < 0.9f) return std::nullopt;
  const bool at_left = rng->Chance(0.5);
  const float x = at_left ? kFromWall : seen.width - kFromWall - pit.width;
  const float left = at_left ? 0.0f : x;
  const float right = at_left ? seen.width - kFromWall - pit.width : 0.0f;
  const float far = seen.length - kFromWall - pit.length;
  const float z = rng->Chance(0.8) || far < front ? far : front;
  PutAt(seen, x, z, &pit);
  const bool is_at_end = seen.length - z - pit.length < 0.1f;
  const std::array<bool, 4> is_free = {true, !is_at_end, left > 0.1f, right > 0.1f};
  DrawRails(is_free, 0.25, rng, &pit);
  pit.depth = Draw(rng, 1.5, 3.0);
  if (rng->Chance(0.8)) pit.first_drop = Draw(rng, kLeastDrop, 0.65);
  pit.goes_up = pit.length > 2.2f && pit.width > 1.9f && rng->Chance(0.5);
  // Its first steps could be entered from the side, and its end from behind.
  if (pit.goes_up) pit.rails[3] = is_free[3];
  if (pit.goes_up) pit.rails[1] = is_free[1];
  if (pit.goes_up) pit.rails[2] = is_free[2];
  return pit;
}

/// In the open floor of a large room, a way left on all sides.
std::optional<Pit> DrawVoid(const FloorPlan& plan, int room, bool is_narrow, Rng* rng) {
  const Seen seen = SeenFrom(plan.rooms[static_cast<std::size_t>(room)], rng->Below(4));
  Pit pit;
  pit.room = room;
  pit.length = is_narrow ? Draw(rng, 3.0, 5.5) : Draw(rng, 2.0, 5.0);
  pit.width = is_narrow ? Draw(rng, 0.8, 1.0) : Draw(rng, 1.4, 3.5);
  constexpr float kAround = 1.3f;
  const float more_x = seen.width - pit.width - 2.0f * kAround;
  const float more_z = seen.length - pit.length - 2.0f * kAround;
  if (more_x < 0.0f || more_z < 0.0f) return std::nullopt;
  const float x = kAround + Draw(rng, 0.0, static_cast<double>(more_x));
  PutAt(seen, x, kAround + Draw(rng, 0.0, static_cast<double>(more_z)), &pit);
  pit.depth = is_narrow ? Draw(rng, 1.3, 1.7) : Draw(rng, 1.5, 3.0);
  if (is_narrow || rng->Chance(0.4)) pit.first_drop = Draw(rng, kLeastDrop, 0.6);
  if (!is_narrow || rng->Chance(0.2))
    DrawRails({true, true, true, true}, is_narrow ? 0.5 : 0.4, rng, &pit);
  return pit;
}

/// Whether the pit's corners lie in the room and not in another of its pits.
bool LiesIn(const FloorPlan& plan, const Pit& pit) {
  const Room& room = plan.rooms[static_cast<std::size_t>(pit.room)];
  const PlanPoint middle = 0.5f * (pit.low() + pit.high());
  const auto outline = pit.Outline();
  return IsInside(room.outline, middle) &&
         std::all_of(outline.begin(), outline.end(), [&](const PlanPoint& p) {
           return IsInside(room.outline, p + 0.01f * (middle - p));
         });
}

}  // namespace

void DigPits(const PitHabit& habit, const Rng& rng, FloorPlan* plan) {
  for (std::size_t i = 0; i < plan->rooms.size(); ++i) {
    const Room& room = plan->rooms[i];
    const bool is_stairwell = room.type == RoomType::kStairwell;
    const bool is_large = room.type == habit.room && room.area() >= kLargeRoom;
    if (!is_stairwell && !is_large) continue;
    Rng draw = rng.Fork("pit", i);
    if (!is_stairwell && !draw.Chance(habit.chance)) continue;
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const int index = static_cast<int>(i);
      const auto pit = is_stairwell ? DrawStair(*plan, index, &draw)
                                    : DrawVoid(*plan, index, habit.is_narrow, &draw);
      if (!pit || !LiesIn(*plan, *pit) || !IsClearOfDoors(*plan, *pit)) continue;
      plan->pits.push_back(*pit);
      break;
    }
  }
}

void FurnishStairwell(RoomFurnisher* room) {
  room->OnWall("exit_sign", 2.1f);
  room->OnWall("fire_extinguisher", 0.8f);
  if (room->Chance(0.5)) room->OnWall(room->Chance(0.5) ? "poster" : "pin_board");
  if (room->Chance(0.4)) room->NearWall("potted_plant");
  FinishRoom(room);
}

}  // namespace bulletnav::sim::building
