// SPDX-License-Identifier: MIT
#include "sim/house/style/palettes.h"

#include <array>

#include "sim/house/style/tint.h"

namespace bulletnav::sim::style {
namespace {

constexpr std::array<std::string_view, 6> kBedding = {
    "linen", "striped_cotton", "checked_bedding", "dotted_fabric", "quilt", "floral_fabric"};
constexpr std::array<std::string_view, 3> kKidsBedding = {"dotted_fabric", "striped_cotton",
                                                          "checked_bedding"};
constexpr std::array<std::string_view, 4> kCushions = {"linen", "velvet", "wool_knit", "canvas"};

constexpr std::array kAppliances = {Surface{"brushed_steel"}, Surface{"white_enamel"},
                                    Surface{"white_enamel", {58, 60, 64}}};

/// What hangs on the wall above a worktop.
Surface DrawBacksplash(const StyleBook& book, const Palette& palette, Rng* rng) {
  if (rng->Chance(0.6)) return rng->Pick(book.bath_tiles);
  return rng->Chance(0.5) ? palette.counter : Surface{"white_subway_tile"};
}

/// The colours every child knows.
void MakeCheerful(Palette* palette, Rng* rng) {
  palette->fabric = {"canvas", rng->Pick(KidsColors())};
  palette->accent = {rng->Pick(kKidsBedding), rng->Pick(KidsColors())};
  palette->bedding = {rng->Pick(kKidsBedding), rng->Pick(KidsColors())};
  palette->cabinet = {"painted_wood", Mix(rng->Pick(KidsColors()), kWhite, 0.2)};
  if (rng->Chance(0.5)) palette->wood = {"painted_wood", Mix(rng->Pick(KidsColors()), kWhite, 0.5)};
  palette->rug =
      rng->Chance(0.5) ? Surface{"kids_rug"} : Surface{"shag_carpet", rng->Pick(KidsColors())};
  palette->shade = {"lamp_shade", Mix(rng->Pick(KidsColors()), kWhite, 0.4)};
}

}  // namespace

const std::vector<Rgb8>& KidsColors() {
  static const std::vector<Rgb8> colors = {Hex(0x7CC4E8), Hex(0xF4A6B8), Hex(0xA6D66A),
                                           Hex(0xF7CF4D), Hex(0xB69AE0), Hex(0xF59A5A),
                                           Hex(0x66CDB8), Hex(0xE86F6F)};
  return colors;
}

Palette DrawPalette(const StyleBook& book, RoomType type, Rng* rng) {
  Palette palette;
  palette.wood = rng->Pick(book.woods);
  palette.other_wood = rng->Pick(book.woods);
  palette.metal = rng->Pick(book.metals);
  palette.fabric = {rng->Pick(book.upholstery), rng->Pick(book.fabrics)};
  palette.accent = {rng->Pick(kCushions), rng->Pick(book.accents)};
  palette.other_accent = {rng->Pick(kCushions), rng->Pick(book.accents)};
  const Rgb8 sheet = rng->Chance(0.5) ? rng->Pick(book.accents) : rng->Pick(book.fabrics);
  palette.bedding = {rng->Pick(kBedding), Mix(sheet, kWhite, rng->Uniform(0.2, 0.6))};
  palette.cabinet = rng->Pick(book.cabinets);
  palette.counter = rng->Pick(book.counters);
  palette.backsplash = DrawBacksplash(book, palette, rng);
  palette.appliance = rng->Pick(kAppliances);
  palette.framed_fronts = book.has_panelled_doors && rng->Chance(0.8);
  palette.handles = rng->Pick(std::array{Handles::kBar, Handles::kKnob, Handles::kNone});
  palette.ceramic = {"ceramic",
                     rng->Chance(0.8) ? kWhite : Mix(rng->Pick(book.accents), kWhite, 0.7)};
  palette.rug = rng->Pick(book.rugs);
  palette.shade = {"lamp_shade", Mix(rng->Pick(book.accents), kWhite, rng->Uniform(0.6, 0.95))};
  const bool is_wet = type == RoomType::kBathroom || type == RoomType::kToilet;
  if (is_wet) palette.rug = {"shag_carpet", rng->Pick(book.accents)};
  if (is_wet) palette.accent.material = "terry_towel";
  if (type == RoomType::kKidsRoom) MakeCheerful(&palette, rng);
  return palette;
}

}  // namespace bulletnav::sim::style
