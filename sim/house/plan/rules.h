// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"

namespace bulletnav::sim::plan {

/// What a room of a type must measure, clear between its walls (m, m2), and how architects place
/// it.
struct RoomRule {
  RoomType type = RoomType::kLivingRoom;
  float min_area = 0.0f;
  float max_area = 0.0f;
  float min_side = 0.0f;
  float max_aspect = 1.0f;       // longer over shorter side of its bounding box
  float small_target = 0.0f;     // wanted area in the smallest houses
  float large_target = 0.0f;     // and in the largest
  float privacy = 0.0f;          // 0 by the living room, 1 at the far end of the bedroom wing
  float min_window_wall = 0.0f;  // clear length of outside wall it needs; 0: may be dark
};

/// Expects: a room of homes (checked).
const RoomRule& RuleOf(RoomType type);

/// Clear width of corridors, metres.
inline constexpr float kMinCorridor = 1.1f;
inline constexpr float kMaxCorridor = 1.8f;

/// Corridors, entries, and the halls of larger buildings.
bool IsCirculation(RoomType type);
/// Bedrooms and kids' rooms.
bool IsSleeping(RoomType type);
/// Rooms with water pipes, which like to share walls.
bool IsWet(RoomType type);
/// Living room, dining room and kitchen.
bool IsPublic(RoomType type);
/// Bathroom, toilet, laundry, storage: they fit behind each other or into a corner of a larger
/// room.
bool IsSmall(RoomType type);

}  // namespace bulletnav::sim::plan
