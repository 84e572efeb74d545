// SPDX-License-Identifier: MIT
// Flat-woven rugs.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {
namespace {

/// Flat weave in undyed wools: bands of several widths, the same to and fro.
Image Striped() {
  constexpr std::pair<float, Color> kBands[] = {
      {0.10f, Hex(0xefece6)}, {0.13f, Hex(0xa09c97)}, {0.16f, Hex(0xefece6)},
      {0.28f, Hex(0xc9c5bf)}, {0.31f, Hex(0xefece6)}, {0.36f, Hex(0x7f7b77)},
      {0.39f, Hex(0xefece6)}, {0.44f, Hex(0xd8d4ce)}, {0.50f, Hex(0xa09c97)}};
  return Shaded([&](Point p) {
    const float y = p.y < 0.5f ? p.y : 1.0f - p.y;
    Color color = kBands[std::size(kBands) - 1].second;
    for (std::size_t i = std::size(kBands) - 1; i-- > 0;) {
      const float end = kBands[i].first;
      color = Mix(kBands[i].second, color, Smooth(end - 0.002f, end + 0.002f, y));
    }
    return color * (0.93f + 0.09f * Wave(128.0f * 0.5f * p.x)) *
           (1.0f + 0.04f * Noise(p, {3, 90, 1}));
  });
}

/// Lozenges inside lozenges between zigzags, as nomads weave them.
Image Geometric() {
  constexpr Color kCream = Hex(0xece4d2);
  constexpr Color kCharcoal = Hex(0x4a4744);
  constexpr Color kRust = Hex(0xb9613e);
  constexpr Color kTeal = Hex(0x4f8285);
  constexpr Color kOchre = Hex(0xd2a24f);
  return Shaded([&](Point p) {
    // Woven patterns step from thread to thread.
    constexpr float kThreads = 64.0f;
    const Point q = {(static_cast<float>(Floor(p.x * kThreads)) + 0.5f) / kThreads,
                     (static_cast<float>(Floor(p.y * kThreads)) + 0.5f) / kThreads};
    const Point cell = {Fraction(2.0f * q.x) - 0.5f, Fraction(2.0f * q.y) - 0.5f};
    const bool odd = (static_cast<int>(2.0f * q.x) + static_cast<int>(2.0f * q.y)) % 2 == 1;
    const float lozenge = std::abs(cell.x) + std::abs(cell.y);
    Color color = kCream;
    if (lozenge > 0.46f && lozenge < 0.53f) color = kCharcoal;
    if (lozenge > 0.62f && lozenge < 0.67f) color = odd ? kOchre : kRust;
    if (lozenge > 0.82f) color = kCharcoal;
    if (lozenge > 0.9f) color = kOchre;
    if (lozenge < 0.36f) color = odd ? kTeal : kRust;
    if (lozenge < 0.25f) color = kCream;
    if (lozenge < 0.17f) color = odd ? kRust : kCharcoal;
    if (lozenge < 0.07f) color = kOchre;
    return color * (0.94f + 0.07f * Wave(64.0f * p.y)) * (1.0f + 0.05f * Noise(p, {128, 20, 1}));
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"geometric_rug", MaterialFamily::kCarpet, 1.2f, Geometric},
    {"striped_rug", MaterialFamily::kCarpet, 1.2f, Striped},
};

}  // namespace

std::span<const MaterialRecipe> Rugs() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
