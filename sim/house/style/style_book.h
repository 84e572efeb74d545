// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/house_style.h"

namespace bulletnav::sim::style {

/// What a decorator of one style chooses from. Lists have at least one entry; colours are for
/// near-white materials, so that the tint is about what one sees.
struct StyleBook {
  StyleKind kind = StyleKind::kModern;
  std::string_view plaster;    // what paint is put on
  std::vector<Rgb8> neutrals;  // paints of living rooms, corridors, kitchens
  std::vector<Rgb8> colors;    // paints of bedrooms, studies, accent walls
  std::vector<std::string_view> wallpapers;
  std::vector<Surface> features;     // brick, stone or boards for a wall that differs
  std::vector<Surface> panels;       // for the lower part of dining room and entry walls
  std::vector<Surface> main_floors;  // living and dining room, corridor, entry
  std::vector<Surface> bedroom_floors;
  std::vector<Surface> kitchen_floors;
  std::vector<Surface> bath_floors;
  std::vector<Surface> bath_tiles;
  std::vector<Surface> ceilings;
  std::vector<Surface> doors;
  std::vector<Surface> frames;  // door casings, baseboards
  std::vector<Surface> window_frames;
  std::vector<Surface> woods;  // of furniture
  std::vector<Surface> metals;
  std::vector<Surface> cabinets;
  std::vector<Surface> counters;
  std::vector<Surface> rugs;
  std::vector<std::string_view> upholstery;  // materials of sofas and chairs, tinted
  std::vector<Rgb8> fabrics;                 // large soft furniture
  std::vector<Rgb8> accents;                 // cushions, curtains
  double wallpaper_chance = 0.2;             // of a bedroom's or living room's accent wall
  double accent_chance = 0.3;                // of a wall that differs
  double panel_chance = 0.0;                 // of wainscot in dining rooms, entries and corridors
  double crown_chance = 0.0;
  double beam_chance = 0.0;  // in living and dining rooms
  bool has_panelled_doors = true;
};

const StyleBook& BookOf(StyleKind kind);

StyleBook ScandinavianBook();
StyleBook ModernBook();
StyleBook RusticBook();
StyleBook ClassicBook();
StyleBook IndustrialBook();
StyleBook MediterraneanBook();
StyleBook CountryBook();
StyleBook RetroBook();

}  // namespace bulletnav::sim::style
