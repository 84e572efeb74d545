// SPDX-License-Identifier: MIT
// Painted walls and panelling: white, to be tinted.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kPaint = Hex(0xefeeeb);

Image PlasterSmooth() {
  const Field cloud(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 1}, 3);
  });
  return Shaded([&](Point p) {
    return kPaint * (1.0f + 0.01f * cloud(p) + 0.007f * Noise(p, {100, 100, 2}));
  });
}

/// Render put on with a float: soft bumps of a few centimetres, lit from above.
Image PlasterRough() {
  const Field height(128, 128, [](Point p) {
    return Fbm(p, {22, 26, 5}, 2);
  });
  const Field cloud(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 6}, 2);
  });
  return Shaded([&](Point p) {
    const float slope = height(p) - height({p.x - 0.004f, p.y - 0.008f});
    return kPaint * (0.985f - 0.11f * slope + 0.02f * cloud(p) + 0.012f * Noise(p, {120, 120, 7}));
  });
}

/// Brightness of a profile's edge that faces light (above) or shade (below), at x in its width.
float Groove(float x, float width) {
  return -0.24f * Smooth(width, 0.3f * width, std::abs(x)) +
         0.05f * Smooth(width, 0.0f, std::abs(x - 1.6f * width));
}

/// Tongue and groove boards 10 cm wide with a bead along each joint.
Image Beadboard() {
  return Shaded([](Point p) {
    const float x = Fraction(4.0f * p.x);
    const float light = 1.4f * Groove(x - 0.5f, 0.05f) + 0.9f * Groove(x - 0.68f, 0.04f) +
                        0.012f * Noise(p, {60, 2, 1});
    return kPaint * (1.0f + light);
  });
}

/// One raised panel in its frame; the next begins where the picture ends.
Image Wainscot() {
  return Shaded([](Point p) {
    const Point c = p - Point{0.5f, 0.5f};
    // Inwards distance from the panel's opening, and which of its sides is the nearest.
    const float across = 0.39f - std::abs(c.x);
    const float down = 0.36f - std::abs(c.y);
    const float in = std::min(across, down);
    const bool level = down < across;
    const float facing = level ? (c.y < 0.0f ? -1.0f : 1.0f) : (c.x < 0.0f ? -0.55f : 0.55f);
    const float moulding = Smooth(0.0f, 0.01f, in) * Smooth(0.035f, 0.025f, in);
    const float field = Smooth(0.075f, 0.08f, in) * Smooth(0.125f, 0.12f, in);
    const float line = Smooth(0.006f, 0.0f, std::abs(in)) +
                       0.8f * Smooth(0.006f, 0.0f, std::abs(in - 0.035f)) +
                       0.5f * Smooth(0.005f, 0.0f, std::abs(in - 0.125f));
    const float light = 0.09f * facing * moulding - 0.07f * facing * field - 0.17f * line;
    return kPaint * (1.0f + light + 0.006f * Noise(p, {4, 50, 1}));
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"beadboard", MaterialFamily::kPaint, 0.4f, Beadboard},
    {"plaster_rough", MaterialFamily::kPaint, 2.0f, PlasterRough},
    {"plaster_smooth", MaterialFamily::kPaint, 2.0f, PlasterSmooth},
    {"wainscot", MaterialFamily::kPaint, 0.8f, Wainscot},
};

}  // namespace

std::span<const MaterialRecipe> Paints() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
