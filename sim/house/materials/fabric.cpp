// SPDX-License-Identifier: MIT
// Plain cloth, near white so that tints colour it.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

Image Linen() {
  return Shaded([](Point p) {
    return Hex(0xebe8e0) * Slubs(p, 0.06f, 1);
  });
}

Image CanvasCloth() {
  return Shaded([](Point p) {
    return Hex(0xf0eee9) * (PlainWeave(p, 64) * (1.0f + 0.03f * Noise(p, {6, 64, 1})));
  });
}

/// The pile lies one way here and another there.
Image Velvet() {
  const Field nap(64, 64, [](Point p) {
    return Fbm(p, {3, 4, 1}, 3);
  });
  return Shaded([&](Point p) {
    const float fold = nap(p + Point{0.08f, 0.05f} * nap({p.y, p.x}));
    return Hex(0xe4e2e2) * (1.0f + 0.09f * fold + 0.03f * Noise(p, {128, 100, 2}));
  });
}

/// Twill whose ribs change direction every few centimetres, with flecks.
Image Tweed() {
  return Shaded([](Point p) {
    constexpr float kColumns = 5.0f;
    const float zigzag = std::abs(Fraction(kColumns * p.x) - 0.5f);
    const float rib = Wave(26.0f * p.y + 4.0f * zigzag);
    const float fleck = Noise(p, {90, 60, 1});
    const float tone = 0.8f + 0.2f * Smooth(0.25f, 0.75f, rib) + 0.05f * fleck;
    return Hex(0xf0eeea) * (fleck > 0.75f ? 0.78f * tone : tone);
  });
}

/// Chunky jersey with a cable every eight stitches.
Image WoolKnit() {
  return Shaded([](Point p) {
    const float band = 4.0f * p.x;
    const float x = Fraction(band);
    const bool cable = x > 0.62f;
    const float across = (x - 0.81f) / 0.19f;
    if (!cable) return Hex(0xfffdf8) * Stitches(p, 32, 28);
    // Two plies crossing each other.
    const float ply = std::abs(across) < 1.0f ? Wave(7.0f * p.y + 0.45f * across) : 0.0f;
    const float round = 1.0f - across * across;
    const float yarn = 0.95f + 0.05f * Wave(28.0f * p.y + 2.0f * across);
    return Hex(0xfffdf8) *
           (yarn * (0.62f + 0.42f * (0.3f + 0.7f * ply) * Smooth(0.0f, 0.5f, round)));
  });
}

/// Loops, and one woven band across.
Image TerryTowel() {
  return Shaded([](Point p) {
    const float pile = 0.86f + 0.16f * (1.0f - Scatter(p, {56, 56, 1}).first);
    const float in = std::abs(p.y - 0.5f);
    const float band = Smooth(0.064f, 0.058f, in);
    const float ridges =
        0.9f + 0.08f * Wave(60.0f * p.y) - 0.1f * Smooth(0.012f, 0.006f, std::abs(in - 0.045f));
    return Hex(0xf2f1ee) * Mix(pile, ridges, band);
  });
}

/// Grain of small cells parted by creases, and the shine of wear.
Image Leather() {
  const Field wear(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 1}, 3);
  });
  const Field bend(128, 128, [](Point p) {
    return Noise(p, {30, 30, 2});
  });
  return Shaded([&](Point p) {
    const Nearest cell = Scatter(p + Point{bend(p), bend({p.y, p.x})} * 0.006f, {96, 96, 3}, 0.9f);
    const float crease = Smooth(0.24f, 0.02f, cell.second - cell.first);
    const float fold = Smooth(0.05f, 0.0f, std::abs(wear({p.y, p.x})));
    return Hex(0xe8e4df) * (1.0f + 0.05f * wear(p) - 0.1f * crease - 0.03f * fold);
  });
}

/// Padded diamonds between lines of stitches.
Image Quilt() {
  return Shaded([](Point p) {
    const float a = 4.0f * (p.x + p.y);
    const float b = 4.0f * (p.x - p.y);
    const float to_seam = std::min(std::min(Fraction(a), 1.0f - Fraction(a)),
                                   std::min(Fraction(b), 1.0f - Fraction(b)));
    const float puff = Smooth(0.0f, 0.4f, to_seam);
    // Each diamond is lit from above: its lower corner, where both fractions end, lies in shade.
    const float lower = Fraction(a) - Fraction(b);
    const float stitch =
        Smooth(0.035f, 0.015f, to_seam) *
        Smooth(0.3f, 0.6f,
               Wave(10.0f * (to_seam == Fraction(a) || to_seam == 1.0f - Fraction(a) ? b : a)));
    return Hex(0xf3f2ef) * (0.86f + 0.13f * puff - 0.05f * lower * (1.0f - puff) - 0.12f * stitch) *
           Slubs(p, 0.01f, 1);
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"canvas", MaterialFamily::kFabric, 0.5f, CanvasCloth},
    {"leather", MaterialFamily::kFabric, 0.8f, Leather},
    {"linen", MaterialFamily::kFabric, 0.5f, Linen},
    {"quilt", MaterialFamily::kFabric, 0.6f, Quilt},
    {"terry_towel", MaterialFamily::kFabric, 0.4f, TerryTowel},
    {"tweed", MaterialFamily::kFabric, 0.4f, Tweed},
    {"velvet", MaterialFamily::kFabric, 0.6f, Velvet},
    {"wool_knit", MaterialFamily::kFabric, 0.4f, WoolKnit},
};

}  // namespace

std::span<const MaterialRecipe> Fabrics() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
