// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/house/house_style.h"

namespace bulletnav::sim::style {

/// A colour of a book, written 0xRRGGBB there.
struct Paint {
  Rgb8 color = kWhite;
  operator const Rgb8&() const { return color; }
};

/// What a decorator of one style chooses from: assets/styles/NAME.yaml, where a colour is 0xRRGGBB
/// and a surface a material or {material: colour}. Lists have at least one entry; colours are for
/// near-white materials, so that the tint is about what one sees.
struct StyleBook {
  std::string plaster;          // what paint is put on
  std::vector<Paint> neutrals;  // paints of living rooms, corridors, kitchens
  std::vector<Paint> colors;    // paints of bedrooms, studies, accent walls
  std::vector<std::string> wallpapers;
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
  std::vector<std::string> upholstery;  // materials of sofas and chairs, tinted
  std::vector<Paint> fabrics;           // large soft furniture
  std::vector<Paint> accents;           // cushions, curtains
  double wallpaper_chance = 0.2;        // of a bedroom's or living room's accent wall
  double accent_chance = 0.3;           // of a wall that differs
  double panel_chance = 0.0;            // of wainscot in dining rooms, entries and corridors
  double crown_chance = 0.0;
  double beam_chance = 0.0;  // in living and dining rooms
  bool has_panelled_doors = true;

  template <class V>
  void Visit(V& v) {
    v.Required("plaster", plaster);
    v.Required("neutrals", neutrals);
    v.Required("colors", colors);
    v.Required("wallpapers", wallpapers);
    v.Required("features", features);
    v.Required("panels", panels);
    v.Required("main_floors", main_floors);
    v.Required("bedroom_floors", bedroom_floors);
    v.Required("kitchen_floors", kitchen_floors);
    v.Required("bath_floors", bath_floors);
    v.Required("bath_tiles", bath_tiles);
    v.Required("ceilings", ceilings);
    v.Required("doors", doors);
    v.Required("frames", frames);
    v.Required("window_frames", window_frames);
    v.Required("woods", woods);
    v.Required("metals", metals);
    v.Required("cabinets", cabinets);
    v.Required("counters", counters);
    v.Required("rugs", rugs);
    v.Required("upholstery", upholstery);
    v.Required("fabrics", fabrics);
    v.Required("accents", accents);
    v("wallpaper_chance", wallpaper_chance);
    v("accent_chance", accent_chance);
    v("panel_chance", panel_chance);
    v("crown_chance", crown_chance);
    v("beam_chance", beam_chance);
    v("has_panelled_doors", has_panelled_doors);
  }
};

/// The book of a style, which is part of the program. Throws FileError at the place of what is
/// wrong in it.
const StyleBook& BookOf(StyleKind kind);
/// Reads the text of a book; `file` stands for it in errors, which are FileErrors.
StyleBook ReadBook(const std::string& text, const std::filesystem::path& file);

}  // namespace bulletnav::sim::style
