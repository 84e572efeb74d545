// SPDX-License-Identifier: MIT
// Materials of small things: plastic, paper, glass, cork, plants...
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/noise.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {
namespace {

constexpr int kCoarse = 128;  // side of pictures that show next to nothing

Image Ceramic() {
  return Shaded(
      [](Point p) {
        return Hex(0xf6f5f1) * (0.995f + 0.012f * Fbm(p, {3, 3, 1}, 2));
      },
      kCoarse);
}

Image Plastic() {
  return Shaded(
      [](Point p) {
        return Hex(0xebebeb) *
               (1.0f + 0.012f * Noise(p, {60, 60, 1}) + 0.01f * Noise(p, {2, 2, 2}));
      },
      kCoarse);
}

Image Rubber() {
  return Shaded(
      [](Point p) {
        const float dimple = Smooth(0.5f, 0.2f, Scatter(p, {26, 26, 1}, 0.0f).first);
        return Hex(0xe9e9e9) * (0.96f + 0.06f * dimple + 0.02f * Noise(p, {60, 60, 1}));
      },
      kCoarse);
}

Image Paper() {
  return Shaded(
      [](Point p) {
        return Hex(0xf4f0e4) * (1.0f + 0.015f * Fbm(p, {12, 12, 1}, 3));
      },
      kCoarse);
}

/// Pleated cloth: soft vertical folds, slubs across.
Image LampShade() {
  return Shaded([](Point p) {
    const float pleat = Wave(24.0f * p.x) - 0.5f;
    const float slub = 0.5f * Noise(p, {10, 90, 1}) + 0.5f * Noise(p, {90, 10, 2});
    return Hex(0xf4efe3) * (0.97f + 0.07f * pleat + 0.02f * slub);
  });
}

Image Cardboard() {
  const Field cloud(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 2}, 2);
  });
  return Shaded([&](Point p) {
    const float flute = Wave(60.0f * p.x) - 0.5f;
    const float fibre = Noise(p, {40, 80, 1});
    return Hex(0xc29d70) * (1.0f + 0.035f * flute + 0.03f * fibre + 0.02f * cloud(p));
  });
}

/// Granules of two browns pressed together.
Image Cork() {
  const Field drifts(64, 64, [](Point p) {
    return Fbm(p, {6, 6, 2}, 2);
  });
  return Shaded([&](Point p) {
    const Nearest granule = Scatter(p, {48, 48, 1});
    const float drift = 0.15f * drifts(p);
    const Color cork = Mix(Hex(0xa87844), Hex(0xd6ab74), Random(granule.id, 1) + drift);
    const float gap = Smooth(0.14f, 0.0f, granule.second - granule.first);
    return cork * (1.0f - 0.3f * gap - 0.25f * (Random(granule.id, 2) < 0.08f ? 1.0f : 0.0f));
  });
}

/// Glass one cannot see through here: pale green-grey with slanting reflections.
Image Glass() {
  return Shaded(
      [](Point p) {
        const float slant = Fraction(p.x + p.y);
        const float broad = Smooth(0.1f, 0.16f, slant) * Smooth(0.42f, 0.36f, slant);
        const float thin = Smooth(0.48f, 0.5f, slant) * Smooth(0.55f, 0.53f, slant);
        return Hex(0xcbdcdb) + Grey(16.0f * broad + 14.0f * thin + 4.0f * (Wave(p.x - p.y) - 0.5f));
      },
      kCoarse);
}

Image Soil() {
  return Shaded([](Point p) {
    const Nearest crumb = Scatter(p, {36, 36, 1});
    const float round = 1.0f - 0.7f * crumb.first;
    const Color earth = Mix(Hex(0x4c382a), Hex(0x86674b), Random(crumb.id, 1));
    const bool pebble = Random(crumb.id, 2) < 0.04f;
    return (pebble ? Hex(0xb8ab98) : earth) * (0.55f + 0.6f * round);
  });
}

/// Foliage: leaves heaped from the dark inside to the light outside.
Image Leaves() {
  Canvas canvas(Hex(0x1f3a1c));
  Rng rng(0, "leaves");
  constexpr int kCount = 360;
  for (int i = 0; i < kCount; ++i) {
    const float light = static_cast<float>(i) / kCount;
    const Point root = Anywhere(rng);
    const float angle = Between(rng, -1.3f, 1.3f) + (i % 3 == 0 ? kPi : 0.0f);
    const float length = Between(rng, 0.1f, 0.19f);
    const Point tip = root + Turned({0.0f, length}, angle);
    const Leaf leaf = {root, tip, 0.42f * length};
    const Color green =
        Mix(Hex(0x2c5a2a), Mix(Hex(0x5e9a47), Hex(0x86b45a), Between(rng, 0.0f, 1.0f)), light);
    // One half of a leaf is turned to the light.
    const Point side = {tip.y - root.y, root.x - tip.x};
    canvas.Paint(leaf, [&](Point p) {
      return green * (Dot(p - root, side) > 0.0f ? 1.1f : 0.9f);
    });
    canvas.Paint(Stroke{root, Point{Mix(root.x, tip.x, 0.9f), Mix(root.y, tip.y, 0.9f)}, 0.004f},
                 Mix(green, Hex(0xd8e8b0), 0.4f), {0.7f, 0.0f});
  }
  return canvas.Finish();
}

/// Basket work: rods pass in front of one upright stake and behind the next.
Image Wicker() {
  return Shaded([](Point p) {
    constexpr int kStakes = 10;
    constexpr int kRods = 18;
    const float x = p.x * kStakes;
    const float y = p.y * kRods;
    const int row = static_cast<int>(y);
    // 1 where the rod is in front, 0 where it is behind; the next row does the opposite.
    const float front = Wave(0.5f * (x + static_cast<float>(row)));
    const float across = 2.0f * Fraction(y) - 1.0f;
    const float round = std::sqrt(std::max(0.0f, 1.0f - across * across));
    const float tone =
        0.6f * Random(static_cast<std::uint32_t>(row), 1) + 0.25f * Noise(p, {4, 128, 1}) + 0.2f;
    const Color rod = Mix(Hex(0xb5854e), Hex(0xdcb57c), tone) *
                      ((0.4f + 0.65f * round) * (0.55f + 0.48f * front));
    const float to_stake = std::abs(Fraction(x + 0.5f) - 0.5f);
    const float behind = Smooth(0.4f, 0.2f, front) * Smooth(0.2f, 0.15f, to_stake);
    const Color stake = Hex(0xc08e55) * (1.05f - 2.2f * to_stake);
    return Mix(rod, stake, behind);
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"cardboard", MaterialFamily::kOther, 0.6f, Cardboard},
    {"ceramic", MaterialFamily::kOther, 0.6f, Ceramic},
    {"cork", MaterialFamily::kOther, 0.6f, Cork},
    {"glass", MaterialFamily::kOther, 1.0f, Glass},
    {"lamp_shade", MaterialFamily::kOther, 0.6f, LampShade},
    {"leaves", MaterialFamily::kOther, 0.4f, Leaves},
    {"paper", MaterialFamily::kOther, 0.6f, Paper},
    {"plastic", MaterialFamily::kOther, 0.6f, Plastic},
    {"rubber", MaterialFamily::kOther, 0.6f, Rubber},
    {"soil", MaterialFamily::kOther, 0.4f, Soil},
    {"wicker", MaterialFamily::kOther, 0.3f, Wicker},
};

}  // namespace

std::span<const MaterialRecipe> Plains() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
