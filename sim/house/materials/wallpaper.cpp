// SPDX-License-Identifier: MIT
// Wallpapers in greys on a light ground: one tint colours both.
#include "sim/base/elementary.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/layout.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/random.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kGround = Hex(0xf2f0ec);
constexpr Color kPale = Hex(0xd9d6d1);
constexpr Color kInk = Hex(0xbab6b0);

/// Two ornaments a picture, the second half a drop lower, in a net of ogees.
Image Damask() {
  Canvas canvas(kGround);
  canvas.Shade([](Point p) {
    // The net's lines sway around the ornaments: where cosines of the two axes balance.
    const float net = Cos(2.0f * kPi * p.x) + Cos(2.0f * kPi * p.y);
    const float sway = net + 0.35f * Cos(2.0f * kPi * p.x) * Cos(2.0f * kPi * p.y);
    return Mix(kGround, kPale, Smooth(0.12f, 0.08f, std::abs(sway)));
  });
  PaintDamask(&canvas, {0.0f, 0.0f}, 0.86f, kInk);
  PaintDamask(&canvas, {0.5f, 0.5f}, 0.86f, kInk);
  return canvas.Finish();
}

/// Muted roses and sage leaves, scattered.
Image Floral() {
  constexpr Color kPetals[] = {Hex(0xcf9f9b), Hex(0xdcb9a8), Hex(0xb9a3b8)};
  Canvas canvas(Hex(0xf3f0e9));
  Rng rng(0, "floral_wallpaper");
  constexpr int kCells = 3;
  for (int i = 0; i < kCells * kCells; ++i) {
    const Point cell = CellOf(i, kCells) + Point{i / kCells % 2 == 0 ? 0.3f : 0.7f, 0.5f};
    const Point centre =
        cell * (1.0f / kCells) + Point{Between(rng, -0.03f, 0.03f), Between(rng, -0.03f, 0.03f)};
    const float angle = Between(rng, -0.8f, 0.8f);
    for (const float side : {0.75f, -0.75f, 2.6f}) {
      PaintFrond(&canvas, centre, centre + Turned({0.0f, 0.17f}, angle + side), 4, Hex(0xb1bba0));
    }
    PaintFlower(&canvas, centre, 0.085f, angle, {6, OneOf(rng, kPetals), Hex(0xe9d9a8)});
    const Point bud = centre + Turned({0.14f, -0.06f}, angle);
    PaintFlower(&canvas, bud, 0.04f, -angle, {5, OneOf(rng, kPetals), Hex(0xe9d9a8)});
  }
  return canvas.Finish();
}

/// Hexagons drawn twice, one line inside the other.
Image Geometric() {
  return Shaded([](Point p) {
    const Piece hexagon = InHexagons(p, 5, 6);
    const float outer = Smooth(0.0095f, 0.0065f, hexagon.edge);
    const float inner = Smooth(0.0045f, 0.0025f, std::abs(hexagon.edge - 0.03f));
    const float filled = Smooth(0.053f, 0.056f, hexagon.edge);
    return Mix(Mix(Mix(kGround, kPale, filled), kInk, 0.8f * inner), Hex(0xa5a19b), outer);
  });
}

Image Grasscloth() {
  const Field drift(64, 64, [](Point p) {
    return Fbm(p, {2, 5, 3}, 3);
  });
  return Shaded([&](Point p) {
    const float blades = 0.6f * Noise(p, {4, 90, 1}) + 0.5f * Noise(p, {9, 128, 2});
    const float knot = Smooth(0.6f, 0.9f, Noise(p, {30, 100, 4}));
    return Hex(0xe9e4d9) * (1.0f + 0.075f * blades + 0.03f * drift(p) - 0.16f * knot);
  });
}

/// Large fronds, dark ones over pale ones.
Image LeafPaper() {
  Canvas canvas(kGround);
  Rng rng(0, "leaf_wallpaper");
  constexpr int kCells = 4;
  for (const auto& [color, shift] : {std::pair{kPale, 0.0f}, {kInk, 0.5f}}) {
    for (int i = 0; i < kCells * kCells; ++i) {
      const int row = i / kCells;
      const Point cell = {static_cast<float>(i % kCells) + shift + (row % 2 == 0 ? 0.0f : 0.5f),
                          static_cast<float>(row) + shift};
      const Point root = cell * (1.0f / kCells);
      const float angle = (row % 2 == 0 ? 1.0f : -1.0f) * Between(rng, 0.3f, 0.9f);
      const Point tip = root + Turned({0.0f, -Between(rng, 0.24f, 0.31f)}, angle);
      PaintFrond(&canvas, root, tip, 8, color);
    }
  }
  return canvas.Finish();
}

Image Polka() {
  Canvas canvas(kGround);
  constexpr int kRows = 6;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kRows / 2; ++i) {
      const float x = (2.0f * static_cast<float>(i) + (row % 2 == 0 ? 0.5f : 1.5f)) / kRows;
      canvas.Paint(Disc({x, (static_cast<float>(row) + 0.5f) / kRows}, 0.05f), kInk);
    }
  }
  return canvas.Finish();
}

Image Stars() {
  Canvas canvas(kGround);
  Rng rng(0, "stars_wallpaper");
  constexpr int kCells = 6;
  for (int i = 0; i < kCells * kCells; ++i) {
    const Point cell =
        CellOf(i, kCells) + Point{Between(rng, 0.3f, 0.7f), Between(rng, 0.3f, 0.7f)};
    const Point centre = cell * (1.0f / kCells);
    const float angle = Between(rng, -0.4f, 0.4f);
    const bool large = (i % kCells + i / kCells) % 2 == 0;
    const float radius = large ? Between(rng, 0.055f, 0.07f) : Between(rng, 0.018f, 0.03f);
    canvas.Paint(Star(centre, 5, {0.45f * radius, radius}, angle), large ? kInk : Hex(0xa8a49e));
  }
  return canvas.Finish();
}

/// Broad and narrow stripes, the broad ones with a satin sheen.
Image Striped() {
  return Shaded([](Point p) {
    const float x = Fraction(3.0f * p.x);
    const float broad = Smooth(0.048f, 0.054f, x) * Smooth(0.502f, 0.496f, x);
    const float thin = Smooth(0.57f, 0.576f, x) * Smooth(0.606f, 0.6f, x) +
                       Smooth(0.945f, 0.951f, x) * Smooth(0.98f, 0.974f, x);
    const float satin = 0.01f * Noise(p, {128, 3, 1});
    return Mix(kGround, Hex(0xc4c0ba), std::max(broad, thin)) * (1.0f + satin);
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"damask_wallpaper", MaterialFamily::kWallpaper, 0.8f, Damask},
    {"floral_wallpaper", MaterialFamily::kWallpaper, 0.8f, Floral},
    {"geometric_wallpaper", MaterialFamily::kWallpaper, 0.8f, Geometric},
    {"grasscloth_wallpaper", MaterialFamily::kWallpaper, 0.8f, Grasscloth},
    {"leaf_wallpaper", MaterialFamily::kWallpaper, 1.0f, LeafPaper},
    {"polka_wallpaper", MaterialFamily::kWallpaper, 0.6f, Polka},
    {"stars_wallpaper", MaterialFamily::kWallpaper, 1.0f, Stars},
    {"striped_wallpaper", MaterialFamily::kWallpaper, 0.6f, Striped},
};

}  // namespace

std::span<const MaterialRecipe> Wallpapers() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
