// SPDX-License-Identifier: MIT
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/layout.h"

namespace bulletnav::sim::materials {
namespace {

constexpr float kMetres = 1.2f;

struct Brick {
  Color pale;
  Color deep;
  Color mortar;
  float burnt = 0.0f;     // share of bricks fired almost black
  float contrast = 1.0f;  // of the mortar's shadow and the surface's roughness
};

/// Bricks of 24 by 7.5 cm in running bond.
Image Wall(const Brick& brick, std::uint32_t seed) {
  const Field bend(128, 128, [](Point p) {
    return Noise(p, {40, 40, 1});
  });
  const Field stain(64, 64, [](Point p) {
    return Fbm(p, {10, 14, 4}, 2);
  });
  return Shaded([&](Point p) {
    // Edges waver a little.
    const Point bent = p + Point{bend(p), bend({p.y, p.x})} * 0.0022f;
    const Piece piece = InBond(bent, {5, 16, 0.5f, seed});
    const float rough = Noise(p, {56, 72, 3});
    const float tone = Random(piece.id, 1) + 0.18f * stain(p);
    Color color = Mix(brick.deep, brick.pale, tone);
    if (Random(piece.id, 2) < brick.burnt) color = color * 0.66f;
    const float light = 1.0f + brick.contrast * (0.07f * rough - 0.12f * (piece.at.y - 0.5f));
    const float mortar = Smooth(0.0068f, 0.0034f, piece.edge);
    const Color joint = brick.mortar * (1.0f + 0.05f * rough);
    return Mix(color * light, joint, mortar);
  });
}

Image Red() {
  return Wall({Hex(0xbf7458), Hex(0x92462f), Hex(0xc9c0b2), 0.1f}, 1);
}
Image Brown() {
  return Wall({Hex(0xa4815f), Hex(0x6d4d38), Hex(0x8f8577), 0.15f}, 2);
}
Image White() {
  return Wall({Hex(0xf1efeb), Hex(0xe2dfda), Hex(0xc6c3bd), 0.0f, 0.55f}, 3);
}

constexpr MaterialRecipe kRecipes[] = {
    {"brown_brick", MaterialFamily::kBrick, kMetres, Brown},
    {"red_brick", MaterialFamily::kBrick, kMetres, Red},
    {"white_brick", MaterialFamily::kBrick, kMetres, White},
};

}  // namespace

std::span<const MaterialRecipe> Brickwork() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
