// SPDX-License-Identifier: MIT
// Carpets of one colour. Fitted ones are near white, to be tinted; jute and berber are as they are.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/shapes.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

/// Dense cut pile, trodden one way here and another there.
Image Plush() {
  const Field nap(64, 64, [](Point p) {
    return Fbm(p, {4, 5, 1}, 3);
  });
  return Shaded([&](Point p) {
    const float tufts = Noise(p, {120, 120, 2}) + 0.6f * Noise(p, {50, 50, 3});
    return Hex(0xe3e0da) * (1.0f + 0.06f * nap(p) + 0.06f * tufts);
  });
}

Image Loop() {
  return Shaded([](Point p) {
    constexpr int kColumns = 40;
    constexpr int kRows = 48;
    const int row = static_cast<int>(p.y * kRows);
    const float tone = 1.0f + 0.05f * (Random(static_cast<std::uint32_t>(row), 1) - 0.5f);
    return Hex(0xf6f3ed) *
           (tone * Loops(p, kColumns, kRows) * (1.0f + 0.03f * Noise(p, {20, 48, 2})));
  });
}

/// Undyed wool loops with brown flecks.
Image Berber() {
  return Shaded([](Point p) {
    constexpr int kLoops = 36;
    const int row = static_cast<int>(p.y * kLoops);
    // Every other row is half a loop further along, as in Loops.
    const int column = Floor(p.x * kLoops + (row % 2 == 0 ? 0.5f : 0.0f)) % kLoops;
    const std::uint32_t loop =
        Hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
    const float kind = Random(loop) + 0.1f * Noise(p, {5, 5, 1});
    const Color wool = kind < 0.09f ? Hex(0xa58b70) : kind < 0.26f ? Hex(0xc9b79d) : Hex(0xe6dbc7);
    return wool * (Loops(p, kLoops, kLoops) * (0.97f + 0.08f * Random(loop, 2)));
  });
}

/// Long strands lying across each other.
Image Shag() {
  Canvas canvas(Hex(0xc4c0ba));
  Rng rng(0, "shag_carpet");
  constexpr int kStrands = 3000;
  for (int i = 0; i < kStrands; ++i) {
    const Point root = Anywhere(rng);
    const float length = Between(rng, 0.03f, 0.07f);
    const Point lie = Turned({length, 0.0f}, Between(rng, 0.0f, 6.28f));
    const float light =
        Mix(0.8f, 1.0f, static_cast<float>(i) / kStrands) * Between(rng, 0.9f, 1.03f);
    canvas.Paint(Stroke{root, root + lie, 0.008f}, Hex(0xf4f1ec) * light);
  }
  return canvas.Finish();
}

/// Plaits side by side, each of two strands.
Image Jute() {
  return Shaded([](Point p) {
    constexpr int kPlaits = 14;
    const float y = p.y * kPlaits;
    const float in = Fraction(y) - 0.5f;
    const auto row = static_cast<std::uint32_t>(y);
    const float strand =
        20.0f * p.x + Random(row, 1) + (in < 0.0f ? 1.1f : -1.1f) * in + (in < 0.0f ? 0.5f : 0.0f);
    const float round = Wave(strand);
    const float valley = Smooth(0.5f, 0.36f, std::abs(in)) * Smooth(-0.02f, 0.06f, std::abs(in));
    const float fibre = Noise(p, {64, 100, 3});
    const Color straw = Mix(Hex(0xa8824f), Hex(0xd9b985),
                            0.35f + 0.35f * round + 0.4f * Random(row, 2) - 0.2f + 0.15f * fibre);
    return straw * (0.68f + 0.36f * valley * (0.6f + 0.4f * round));
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"berber_carpet", MaterialFamily::kCarpet, 0.6f, Berber},
    {"jute_rug", MaterialFamily::kCarpet, 0.6f, Jute},
    {"loop_carpet", MaterialFamily::kCarpet, 0.6f, Loop},
    {"plush_carpet", MaterialFamily::kCarpet, 0.8f, Plush},
    {"shag_carpet", MaterialFamily::kCarpet, 0.8f, Shag},
};

}  // namespace

std::span<const MaterialRecipe> Carpets() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
