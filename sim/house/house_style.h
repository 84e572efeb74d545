// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "sim/config/yaml_reader.h"
#include "sim/house/floor_plan.h"
#include "sim/house/materials.h"
#include "sim/house/palette.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

enum class StyleKind {
  kScandinavian,
  kModern,
  kRustic,
  kClassic,
  kIndustrial,
  kMediterranean,
  kCountry,
  kRetro
};

template <>
struct EnumNames<StyleKind> {
  static constexpr std::array kNames = {std::pair{"scandinavian", StyleKind::kScandinavian},
                                        std::pair{"modern", StyleKind::kModern},
                                        std::pair{"rustic", StyleKind::kRustic},
                                        std::pair{"classic", StyleKind::kClassic},
                                        std::pair{"industrial", StyleKind::kIndustrial},
                                        std::pair{"mediterranean", StyleKind::kMediterranean},
                                        std::pair{"country", StyleKind::kCountry},
                                        std::pair{"retro", StyleKind::kRetro}};
};

/// What covers one face of a wall from the floor to the ceiling.
struct WallFinish {
  Surface upper;
  Surface lower;         // tiles or wainscot, up to `split` metres above the floor
  float split = 0.0f;    // 0: no lower part; at or above the ceiling: nothing else
  bool has_cap = false;  // a ledge covers the edge between them
};

/// Surfaces of one room.
struct RoomStyle {
  WallFinish walls;
  int accent_edge = -1;  // the side of the outline (from this corner to the next) that differs
  WallFinish accent;
  Surface floor;
  Surface ceiling;
  Surface baseboard;
  float baseboard_height = 0.08f;  // 0 where tiles reach the floor
  std::optional<Surface> crown;    // moulding along the ceiling
  std::optional<Surface> beams;    // across the ceiling
  Palette palette;                 // for the furniture

  /// Finish of one side of the outline.
  const WallFinish& WallAt(int edge) const { return edge == accent_edge ? accent : walls; }
};

/// Everything about a house's looks that is not its shape.
struct HouseStyle {
  StyleKind kind = StyleKind::kModern;
  std::vector<RoomStyle> rooms;  // as in FloorPlan::rooms
  Surface door;
  Surface entry_door;
  Surface door_frame;
  Surface handle;
  Surface threshold;
  Surface window_frame;
  Surface window_sill;
  bool has_panelled_doors = true;
  bool has_cased_arches = true;   // boards around arches, else plaster edges
  bool has_glazing_bars = false;  // small panes
  std::vector<float> thresholds;  // heights, as in FloorPlan::openings; 0: the floor runs through
  std::array<Surface, 4> views;   // seen through windows that look west, east, north, south
};

/// Draws a style and with it every surface of a plan's rooms: floors by room type and one floor for
/// the living area, walls painted, papered or tiled, sometimes one that differs, and a palette for
/// the furniture of each room. Rooms are drawn again until each is visibly unlike all others (see
/// Difference). The same plan and rng position give the same style.  Source: ours.
HouseStyle DrawHouseStyle(const FloorPlan& plan, const Rng& rng);

/// How unlike two rooms look: perceptual colour distance (CIE 1976) of walls, floor and furniture,
/// weighted by how much of the view they fill; different kinds of material add to it. About 10 is
/// what one notices at once.
double Difference(const RoomStyle& a, const RoomStyle& b);

}  // namespace bulletnav::sim
