// SPDX-License-Identifier: MIT
// Floors of boards and blocks. Boards run along x.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/layout.h"
#include "sim/house/materials/timber.h"

namespace bulletnav::sim::materials {
namespace {

constexpr float kPlankMetres = 1.8f;
constexpr float kBlockMetres = 1.2f;

/// Brightness near a joint: wide enough to survive being seen from afar.
float Joint(float edge) {
  return 1.0f - 0.5f * Smooth(0.0055f, 0.0005f, edge);
}

Image Planks(const Timber& timber, int rows, std::uint32_t seed) {
  const Log log(timber, kPlankMetres);
  const Boards boards(rows, 2, seed);
  return Shaded([&](Point p) {
    const Piece board = boards(p);
    return log(p, board.id) * Joint(board.edge);
  });
}

Image OakPlanks() {
  return Planks(kOak, 12, 21);
}
Image WalnutPlanks() {
  return Planks(kWalnut, 12, 22);
}
Image PinePlanks() {
  return Planks(kPine, 10, 23);
}

Image GreyPlanks() {
  return Planks({.light = Hex(0xc3bcb1),
                 .dark = Hex(0x8d857b),
                 .streaks = 0.4f,
                 .figure = 0.22f,
                 .rings = 5.0f,
                 .pores = 0.3f,
                 .spread = 0.9f},
                9, 24);
}

Image OakHerringbone() {
  Timber oak = kOak;
  oak.spread = 1.0f;
  const Log log(oak, 0.7f * kBlockMetres);
  return Shaded([&](Point p) {
    const Piece block = InHerringbone(p, 2, 4);
    const Point grain = block.turned ? Point{p.x - p.y, p.x + p.y} : Point{p.x + p.y, p.x - p.y};
    // Blocks lying the other way catch the light differently.
    const float sheen = block.turned ? 0.94f : 1.03f;
    return log(grain, block.id) * (sheen * Joint(block.edge));
  });
}

Image WalnutParquet() {
  const Log log(kWalnut, kBlockMetres);
  return Shaded([&](Point p) {
    const Piece strip = InBasket(p, 4, 4);
    const Point grain = strip.turned ? Point{p.y, p.x} : p;
    const float sheen = strip.turned ? 0.9f : 1.12f;
    return log(grain, strip.id) * (sheen * Joint(strip.edge));
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"grey_planks", MaterialFamily::kWood, kPlankMetres, GreyPlanks},
    {"oak_herringbone", MaterialFamily::kWood, kBlockMetres, OakHerringbone},
    {"oak_planks", MaterialFamily::kWood, kPlankMetres, OakPlanks},
    {"pine_planks", MaterialFamily::kWood, kPlankMetres, PinePlanks},
    {"walnut_parquet", MaterialFamily::kWood, kBlockMetres, WalnutParquet},
    {"walnut_planks", MaterialFamily::kWood, kPlankMetres, WalnutPlanks},
};

}  // namespace

std::span<const MaterialRecipe> WoodFloors() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
