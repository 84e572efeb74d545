// SPDX-License-Identifier: MIT
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {
namespace {

/// Brushed along x, with a broad soft reflection.
Image Brushed(Color color, float brush, float shine, std::uint32_t seed) {
  return Shaded([&](Point p) {
    const float lines = 0.6f * Noise(p, {2, 128, seed}) + 0.6f * Noise(p, {5, 90, seed + 1u});
    const float reflection = Wave(p.x + 0.06f * Noise(p, {2, 2, seed + 2u})) - 0.5f;
    return color * (1.0f + brush * lines + shine * reflection);
  });
}

Image BrushedSteel() {
  return Brushed(Hex(0xb9bbbd), 0.035f, 0.13f, 1);
}
Image Brass() {
  return Brushed(Hex(0xcfa95b), 0.025f, 0.15f, 2);
}
Image Copper() {
  return Brushed(Hex(0xc5805a), 0.025f, 0.15f, 3);
}

/// Polished: bright where it reflects a window, dark where it reflects the room, in upright bands
/// narrow enough to show on a chair's leg.
Image Chrome() {
  return Shaded([](Point p) {
    const float x = Fraction(3.0f * p.x);
    const float bright = Smooth(0.05f, 0.2f, x) * Smooth(0.5f, 0.35f, x);
    const float dark = Smooth(0.5f, 0.62f, x) * Smooth(0.8f, 0.7f, x);
    const Color ground = Hex(0xc0c5c9) * (1.0f + 0.04f * (Wave(p.y) - 0.5f));
    return Mix(Mix(ground, Hex(0xf0f3f5), 0.9f * bright), Hex(0x80878d), 0.75f * dark);
  });
}

Image BlackMetal() {
  return Shaded([](Point p) {
    const float grain = Noise(p, {110, 110, 1});
    return Hex(0x3e3e41) * (1.0f + 0.06f * grain + 0.12f * (Wave(p.x) - 0.5f));
  });
}

Image CastIron() {
  const Field cloud(64, 64, [](Point p) {
    return Fbm(p, {4, 4, 2}, 3);
  });
  return Shaded([&](Point p) {
    const float pits = Fbm(p, {50, 50, 1}, 2);
    return Hex(0x4f4d4c) * (1.0f + 0.16f * pits + 0.08f * cloud(p));
  });
}

Image WhiteEnamel() {
  return Shaded([](Point p) {
    return Hex(0xf4f6f7) * (0.995f + 0.012f * (Wave(p.x) - 0.5f) + 0.006f * Noise(p, {5, 5, 1}));
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"black_metal", MaterialFamily::kMetal, 0.6f, BlackMetal},
    {"brass", MaterialFamily::kMetal, 0.6f, Brass},
    {"brushed_steel", MaterialFamily::kMetal, 0.6f, BrushedSteel},
    {"cast_iron", MaterialFamily::kMetal, 0.6f, CastIron},
    {"chrome", MaterialFamily::kMetal, 0.6f, Chrome},
    {"copper", MaterialFamily::kMetal, 0.6f, Copper},
    {"white_enamel", MaterialFamily::kMetal, 0.8f, WhiteEnamel},
};

}  // namespace

std::span<const MaterialRecipe> Metals() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
