// SPDX-License-Identifier: MIT
// What offices, halls and shops are fitted out with.
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/layout.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {
namespace {

/// Mineral tiles of 60 cm on white rails, pricked all over.
Image CeilingGrid() {
  return Shaded([](Point p) {
    const Piece tile = InBond(p, {2, 2, 0.0f, 3});
    const Nearest prick = Scatter(p, {90, 90, 4});
    const float hole = Smooth(0.26f, 0.16f, prick.first) * Random(prick.id, 5);
    const float tone = 1.0f + 0.02f * (Random(tile.id, 1) - 0.5f) - 0.16f * hole;
    const float rail = Smooth(0.011f, 0.008f, tile.edge);
    const float shade = Smooth(0.02f, 0.011f, tile.edge) - rail;
    return Mix(Hex(0xd7dbdd) * (tone - 0.14f * shade), Hex(0xf6f6f4), rail);
  });
}

/// Sheet metal in waves that run down the picture, screwed on in rows.
Image CorrugatedMetal() {
  return Shaded([](Point p) {
    const float wave = Sin(2.0f * kPi * 8.0f * p.x);
    const float slope = Cos(2.0f * kPi * 8.0f * p.x);
    const float light = 0.86f + 0.09f * slope + 0.05f * wave;
    const float dirt = 0.02f * Noise(p, {12, 2, 1}) + 0.015f * Noise(p, {90, 30, 2});
    const float screw_x = Fraction(8.0f * p.x) - 0.25f;
    const float screw_y = 2.0f * Fraction(2.0f * p.y) - 1.0f;
    const float screw = std::sqrt(screw_x * screw_x + 16.0f * screw_y * screw_y);
    return Hex(0xe2e4e6) * (light + dirt) * (1.0f - 0.35f * Smooth(0.14f, 0.1f, screw));
  });
}

/// Sheets of hospital floors: speckles in three tones, hardly a seam.
Image VinylFloor() {
  return Shaded([](Point p) {
    const Nearest speck = Scatter(p, {56, 56, 7});
    const float tone = Random(speck.id, 2);
    const float in = Smooth(0.5f, 0.3f, speck.first);
    const float cloud = 0.015f * Fbm(p, {3, 3, 8}, 3);
    const float change = tone < 0.35f ? -0.13f : (tone < 0.6f ? -0.06f : 0.05f);
    return Hex(0xd9dbd8) * (1.0f + cloud + in * change);
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"ceiling_grid", MaterialFamily::kOther, 1.2f, CeilingGrid},
    {"corrugated_metal", MaterialFamily::kMetal, 1.0f, CorrugatedMetal},
    {"vinyl_floor", MaterialFamily::kOther, 1.5f, VinylFloor},
};

}  // namespace

std::span<const MaterialRecipe> Fitouts() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
