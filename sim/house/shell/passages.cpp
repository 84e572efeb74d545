// SPDX-License-Identifier: MIT
#include "sim/house/shell/door_leaf.h"
#include "sim/house/shell/faces.h"
#include "sim/house/shell/openings.h"
#include "sim/math/pose.h"

namespace bulletnav::sim::shell {
namespace {

/// Boards around the hole on the wall at z = 0 of the current frame, from x = 0 to `width`.
void AddCasing(const Surface& surface, float width, float top, MeshBuilder* builder) {
  AddBoard(surface, {-kCasingWidth, 0.0f, 0.0f, top}, 0.0f, kCasingDepth, Grain::kUpright, builder);
  AddBoard(surface, {width, 0.0f, width + kCasingWidth, top}, 0.0f, kCasingDepth, Grain::kUpright,
           builder);
  AddBoard(surface, {-kCasingWidth, top, width + kCasingWidth, top + kCasingWidth}, 0.0f,
           kCasingDepth, Grain::kLevel, builder);
}

/// A low board across the doorway, under the leaf.
void AddThreshold(const Surface& surface, const Opening& door, float height, MeshBuilder* builder) {
  const float half = 0.5f * door.wall_thickness + 0.01f;
  AddBoard(surface, {0.0f, 0.0f, door.width(), height}, -half, half, Grain::kLevel, builder);
  builder->Quad(surface, {door.width(), 0.0f, -half}, {0.0f, 0.0f, -half}, {0.0f, height, -half},
                {door.width(), height, -half});
}

/// What lies in the thickness of an outside wall around the entry door.
void CloseEntry(const HouseStyle& style, const Opening& door, MeshBuilder* builder) {
  const RoomStyle& room = style.rooms[static_cast<std::size_t>(door.room_a)];
  const float w = door.width();
  const float half = 0.5f * door.wall_thickness;
  builder->Quad(room.floor, {0, 0, half}, {w, 0, half}, {w, 0, -half}, {0, 0, -half});
  AddPanel(style.entry_door, {-kOverlap, -kOverlap, w + kOverlap, door.top + kOverlap}, -half,
           builder);
}

}  // namespace

void AddPassage(const FloorPlan& plan, const HouseStyle& style, std::size_t opening,
                MeshBuilder* builder) {
  const Opening& door = plan.openings[opening];
  const RoomStyle& room = style.rooms[static_cast<std::size_t>(door.room_a)];
  const bool is_cased = door.kind == OpeningKind::kDoor || style.has_cased_arches;
  const float w = door.width();
  const float half = 0.5f * door.wall_thickness;
  const MeshBuilder::Frame frame(builder, FaceFrame(door.b, door.a));
  const Surface& lining = is_cased ? style.door_frame : room.walls.upper;
  // The reveals begin a little behind the hole's edges, so that no light shines through there.
  AddReveal(lining, {.hole = {0.0f, 0.0f, w, door.top}, .z0 = half, .z1 = -half}, builder);
  if (is_cased) {
    const MeshBuilder::Frame face(builder, Vec(0.0f, 0.0f, half));
    AddCasing(style.door_frame, w, door.top, builder);
  }
  if (is_cased && door.room_b >= 0) {
    const MeshBuilder::Frame face(builder, Vec(w, 0.0f, -half), static_cast<float>(kPi));
    AddCasing(style.door_frame, w, door.top, builder);
  }
  if (door.room_b < 0) CloseEntry(style, door, builder);
  if (style.thresholds[opening] > 0.0f) {
    AddThreshold(style.threshold, door, style.thresholds[opening], builder);
  }
}

}  // namespace bulletnav::sim::shell
