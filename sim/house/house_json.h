// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/house/floor_plan.h"
#include "sim/house/furnishing.h"

namespace bulletnav::sim {

/// What is written beside a generated house, for those who want to know its rooms.
struct HouseDescription {
  std::uint64_t seed = 0;
  std::string style;  // as in EnumNames<StyleKind>; any text
  FloorPlan plan;
  std::string kind = {};  // of the building; empty where only homes are meant
  std::vector<Furnishing> furniture = {};
};

/// JSON, a line for each room, opening and wall; metres, radians, points as the world's [x, z].
/// Keys: seed, style, ceiling, area_m2;
///   rooms [{name, type, area_m2, doors, polygon}], doors: indices of the room's passages;
///   openings [{kind, a, b, bottom, top, wall_thickness, rooms, leaf}], rooms: [room to the left of
///   the way from a to b, room to the right or null for outside], leaf: null or {angle, hinge: "a"
///   or "b", opens_into: index of a room or null for outside};
///   walls [{a, b, thickness, is_outer}]; footprint;
///   where they are known, kind, and furniture [{kind, room, position, yaw, low, high, name}]: the
///   piece's frame stands at position [x, y, z], turned by yaw about y (0: its z is the world's);
///   low and high are its box's corners in that frame; name is its object's in the mesh, if known.
///   Small things on tops, rugs and lamps are left out.
/// Everything reads back equal; of openings without a leaf nothing about a leaf is kept.
std::string ToJson(const HouseDescription& house);

/// Reads what ToJson wrote; further keys are no error. Throws FileError, naming file, place in it
/// and remedy, on bad syntax, missing keys, wrong types, unknown names, indices of nothing, empty
/// shapes, and where areas or doors contradict the shapes.
HouseDescription ReadHouseJson(const std::filesystem::path& file);

}  // namespace bulletnav::sim
