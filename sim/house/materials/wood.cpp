// SPDX-License-Identifier: MIT
// Woods of furniture and doors. The grain runs down the picture: pieces of furniture stand upright.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/layout.h"
#include "sim/house/materials/timber.h"

namespace bulletnav::sim::materials {
namespace {

/// Distance to a board's long edges in fractions of the picture's side, of `rows` boards.
float ToLongEdge(const Piece& board, int rows) {
  return std::min(board.at.y, 1.0f - board.at.y) / static_cast<float>(rows);
}

/// Boards side by side, joined so well that only their tone tells them apart.
Image Panel(Timber timber, int boards, std::uint32_t seed) {
  timber.spread *= 0.7f;
  const Log log(timber, 1.0f);
  return Shaded([&](Point p) {
    const Point along = {p.y, p.x};
    const Piece board = InBond(along, {1, boards, 0.0f, seed});
    const float joint = 1.0f - 0.1f * Smooth(0.005f, 0.0f, ToLongEdge(board, boards));
    return log(along, board.id) * joint;
  });
}

Image Oak() {
  return Panel(kOak, 5, 1);
}
Image Walnut() {
  return Panel(kWalnut, 4, 2);
}
Image Pine() {
  return Panel(kPine, 6, 3);
}

Image Beech() {
  return Panel({.light = Hex(0xe6bd92),
                .dark = Hex(0xc99266),
                .streaks = 0.18f,
                .figure = 0.06f,
                .pores = 0.6f,
                .spread = 0.45f},
               6, 4);
}

Image Mahogany() {
  return Panel({.light = Hex(0xa15a3c),
                .dark = Hex(0x5f2a1b),
                .streaks = 0.34f,
                .figure = 0.2f,
                .rings = 3.0f,
                .pores = 0.45f,
                .spread = 0.6f},
               3, 5);
}

Image Wenge() {
  return Panel({.light = Hex(0x61493a),
                .dark = Hex(0x2c201b),
                .streaks = 0.55f,
                .figure = 0.1f,
                .pores = 0.5f,
                .spread = 0.4f},
               4, 6);
}

Image Bamboo() {
  constexpr float kMetres = 0.8f;
  constexpr int kStrips = 36;
  const Log cane({.light = Hex(0xead09a),
                  .dark = Hex(0xc29c5c),
                  .streaks = 0.2f,
                  .figure = 0.0f,
                  .pores = 0.0f,
                  .spread = 0.9f},
                 kMetres);
  const Boards strips(kStrips, 3, 7);
  return Shaded([&](Point p) {
    // Strips 2 cm wide with a node every 20 to 40 cm.
    const Piece strip = strips({p.y, p.x});
    const float node = std::min(strip.at.x, 1.0f - strip.at.x);
    const float line = Smooth(0.035f, 0.0f, node);
    const float joint = 1.0f - 0.18f * Smooth(0.005f, 0.0f, ToLongEdge(strip, kStrips));
    return cane({p.y, p.x}, strip.id) * joint * (1.0f - 0.3f * line);
  });
}

Image PaintedWood() {
  const Field cloud(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 3}, 2);
  });
  return Shaded([&](Point p) {
    const float grain = 0.6f * Noise(p, {70, 2, 1}) + 0.4f * Noise(p, {128, 6, 2});
    return Hex(0xf1f0ec) * (1.0f + 0.018f * grain + 0.008f * cloud(p));
  });
}

Image WeatheredWood() {
  constexpr float kMetres = 1.2f;
  const Log driftwood({.light = Hex(0xb4a796),
                       .dark = Hex(0x75695c),
                       .streaks = 0.5f,
                       .figure = 0.22f,
                       .rings = 6.0f,
                       .pores = 0.5f,
                       .spread = 1.0f,
                       .knots = 0.35f},
                      kMetres);
  const Boards boards(8, 1, 11);
  return Shaded([&](Point p) {
    const Piece board = boards(p);
    const float gap = Smooth(0.007f, 0.002f, board.edge);
    const float crack = Smooth(0.55f, 0.85f, Noise(p, {4, 64, board.id}));
    const Color wood = driftwood(p, board.id);
    const Color warm = Mix(wood, wood * Color{1.08f, 0.97f, 0.84f}, Random(board.id, 9));
    return warm * (1.0f - 0.4f * crack) * (1.0f - 0.7f * gap);
  });
}

/// Caning of chair seats: pairs of strands and diagonals around eight-sided holes of 1.4 cm.
Image Rattan() {
  return Shaded([](Point p) {
    constexpr int kHoles = 28;
    const Point q = p * static_cast<float>(kHoles);
    const Point in = {std::abs(Fraction(q.x) - 0.5f), std::abs(Fraction(q.y) - 0.5f)};
    const float octagon = std::max({in.x, in.y, 0.72f * (in.x + in.y)});
    const float hole = Smooth(0.33f, 0.22f, octagon);
    const float strand = 0.86f + 0.14f * Wave(2.0f * (in.x > in.y ? q.x : q.y));
    const float tone = 1.0f + 0.05f * Noise(p, {28, 2, 1}) + 0.05f * Noise(p, {2, 28, 2});
    return Mix(Hex(0xd9b27a) * (strand * tone), Hex(0x6b4d2e), hole);
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"bamboo", MaterialFamily::kWood, 0.8f, Bamboo},
    {"beech", MaterialFamily::kWood, 1.0f, Beech},
    {"mahogany", MaterialFamily::kWood, 1.0f, Mahogany},
    {"oak", MaterialFamily::kWood, 1.0f, Oak},
    {"painted_wood", MaterialFamily::kWood, 1.0f, PaintedWood},
    {"pine", MaterialFamily::kWood, 1.0f, Pine},
    {"rattan", MaterialFamily::kWood, 0.4f, Rattan},
    {"walnut", MaterialFamily::kWood, 1.0f, Walnut},
    {"weathered_wood", MaterialFamily::kWood, 1.2f, WeatheredWood},
    {"wenge", MaterialFamily::kWood, 1.0f, Wenge},
};

}  // namespace

std::span<const MaterialRecipe> Woods() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
