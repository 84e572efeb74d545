// SPDX-License-Identifier: MIT
// Stone of worktops, floors and walls, and concrete.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/layout.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {
namespace {

constexpr int kSmooth = 64;  // samples of fields without fine detail

/// Where cracks healed by another mineral run: lines where a bent noise passes through zero.
class Veins {
 public:
  Veins(int cells, std::uint32_t seed)
      : x_(kSmooth, kSmooth,
           [&](Point p) {
             return Fbm(p, {3, 3, seed + 1u}, 3);
           }),
        y_(kSmooth, kSmooth,
           [&](Point p) {
             return Fbm(p, {3, 3, seed + 2u}, 3);
           }),
        height_(kSide, kSide, [&](Point p) {
          return Noise(p, {cells, 2 * cells, seed}) + 0.15f * Noise(p, {12, 12, seed + 3u});
        }) {}

  /// 1 on a vein, 0 further than `width` from it.
  float operator()(Point p, float width) const {
    const Point bent = p + Point{x_(p), y_(p)} * 0.08f;
    // A slanting coordinate makes veins run across the slab rather than around.
    return Smooth(width, 0.0f, std::abs(height_({bent.x + bent.y, bent.y})));
  }

 private:
  static constexpr int kSide = 128;
  Field x_;
  Field y_;
  Field height_;
};

Image WhiteMarble() {
  const Veins broad(2, 10);
  const Veins fine(4, 20);
  const Field cloud(kSmooth, kSmooth, [](Point p) {
    return Fbm(p, {3, 3, 4}, 3);
  });
  return Shaded([&](Point p) {
    const float strength = Smooth(-0.9f, 0.7f, cloud({p.y, p.x}));
    const Color stone = Hex(0xefeeec) * (1.0f + 0.03f * cloud(p));
    const Color hazy = Mix(stone, Hex(0xb9bcc2), 0.6f * strength * broad(p, 0.4f));
    const Color veined = Mix(hazy, Hex(0x868b93), 0.85f * strength * broad(p, 0.075f));
    return Mix(veined, Hex(0xa9a6a3), 0.45f * fine(p, 0.07f));
  });
}

Image BlackMarble() {
  const Veins broad(2, 30);
  const Veins fine(4, 40);
  const Field cloud(kSmooth, kSmooth, [](Point p) {
    return Fbm(p, {4, 4, 4}, 3);
  });
  return Shaded([&](Point p) {
    const float strength = Smooth(-0.7f, 0.8f, cloud({p.y, p.x}));
    const Color stone = Hex(0x37373c) * (1.0f + 0.15f * cloud(p));
    const Color veined = Mix(stone, Hex(0xd8d2c6), 0.9f * strength * broad(p, 0.08f));
    return Mix(veined, Hex(0x86817a), 0.55f * fine(p, 0.055f));
  });
}

/// Crystals of three minerals, a few millimetres each, in drifts.
Image Granite(Color ground, Color light, Color dark, std::uint32_t seed) {
  const Field drift(kSmooth, kSmooth, [&](Point p) {
    return Fbm(p, {6, 6, seed + 1u}, 3);
  });
  return Shaded([&](Point p) {
    const Nearest crystal = Scatter(p, {84, 84, seed});
    const float kind = Random(crystal.id) + 0.25f * drift(p);
    const Color mineral = kind < 0.3f ? dark : kind < 0.66f ? ground : light;
    const Color flecked = Mix(mineral, dark, Smooth(0.55f, 0.8f, Noise(p, {110, 110, seed + 2u})));
    return flecked * (1.0f + 0.12f * (Random(crystal.id, 3) - 0.5f));
  });
}

Image GreyGranite() {
  return Granite(Hex(0x9c9d9f), Hex(0xc9c8c5), Hex(0x4f5054), 51);
}
Image BrownGranite() {
  return Granite(Hex(0x94725a), Hex(0xc4a184), Hex(0x43332b), 61);
}

Image Limestone() {
  const Field cloudy(128, 128, [](Point p) {
    return Fbm(p, {4, 6, 1}, 4);
  });
  return Shaded([&](Point p) {
    const float cloud = cloudy(p);
    const float shell = Smooth(0.5f, 0.8f, Noise(p, {60, 80, 2}));
    return Hex(0xd8cfbd) * (1.0f + 0.06f * cloud - 0.1f * shell);
  });
}

/// Poured against boards a metre wide: stains, pinholes and the boards' joints with tie holes.
Image Concrete() {
  const Field cloudy(128, 128, [](Point p) {
    return Fbm(p, {3, 3, 1}, 5);
  });
  const Field stained(kSmooth, kSmooth, [](Point p) {
    return Smooth(0.2f, 1.1f, Fbm(p, {5, 2, 2}, 3));
  });
  return Shaded([&](Point p) {
    const float cloud = cloudy(p);
    const float stain = stained(p);
    const float pinhole = Smooth(0.62f, 0.8f, Noise(p, {70, 70, 3}));
    const Piece board = InBond(p, {1, 2, 0.0f, 4});
    const float joint = Smooth(0.007f, 0.002f, std::min(board.at.y, 1.0f - board.at.y) * 0.5f);
    const Point tie = {std::abs(Fraction(2.0f * p.x) - 0.5f) * 0.5f,
                       std::abs(Fraction(2.0f * p.y) - 0.5f) * 0.5f};
    const float hole = Smooth(0.012f, 0.007f, Length(tie));
    const float tone = 1.0f + 0.07f * cloud - 0.08f * stain - 0.15f * pinhole - 0.16f * joint +
                       0.06f * (Random(board.id) - 0.5f);
    return Hex(0xb4b2ad) * (tone * (1.0f - 0.45f * hole));
  });
}

/// Rough stones in pale mortar, each rounded by light from above.
Image StoneWall() {
  constexpr Color kStones[] = {Hex(0xa69c8c), Hex(0xb8a98e), Hex(0x8f8a82),
                               Hex(0xc2b59d), Hex(0x9c8b76), Hex(0x7f7b75)};
  const Field bend(kSmooth, kSmooth, [](Point p) {
    return Noise(p, {12, 12, 1});
  });
  const Field grain(128, 128, [](Point p) {
    return Fbm(p, {24, 24, 4}, 2);
  });
  return Shaded([&](Point p) {
    const Point bent = p + Point{bend(p), bend({p.y, p.x})} * 0.012f;
    const Piece stone = InRubble(bent, {6, 9, 3}, 0.75f);
    const float rough = grain(p);
    const float dome = Smooth(0.0f, 0.03f, stone.edge);
    const float light = 0.8f + 0.2f * dome - 0.16f * (stone.at.y - 0.5f) + 0.09f * rough;
    const Color color = kStones[Hash(stone.id, 1) % std::size(kStones)];
    const float mortar = Smooth(0.0115f, 0.0065f, stone.edge + 0.003f * rough);
    return Mix(color * light, Hex(0xcdc5b6) * (0.9f + 0.06f * rough), mortar);
  });
}

/// A broken chip of about this radius.
Polygon Chip(Rng& rng, float radius) {
  const Point centre = Anywhere(rng);
  const int corners = rng.Between(4, 6);
  std::vector<Point> outline;
  for (int i = 0; i < corners; ++i) {
    const float turn =
        (static_cast<float>(i) + Between(rng, 0.0f, 0.7f)) / static_cast<float>(corners);
    const float far = radius * Between(rng, 0.7f, 1.15f);
    outline.push_back(centre + Turned({far, 0.0f}, 2.0f * kPi * turn));
  }
  return Polygon(outline);
}

/// Chips of marble in several sizes in a pale cement.
Image Terrazzo() {
  constexpr Color kChips[] = {Hex(0xa9774f), Hex(0x8a8f8c), Hex(0x5f6468),
                              Hex(0xd9b48a), Hex(0xb5bdb4), Hex(0x7c4f3c)};
  Canvas canvas(Color{});
  canvas.Shade([](Point p) {
    return Hex(0xe8e2d8) * (1.0f + 0.015f * Noise(p, {8, 8, 1}));
  });
  Rng rng(0, "terrazzo");
  for (const auto& [count, radius] : {std::pair{500, 0.007f}, {220, 0.013f}, {80, 0.022f}}) {
    for (int i = 0; i < count; ++i) {
      canvas.Paint(Chip(rng, radius), OneOf(rng, kChips));
    }
  }
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"black_marble", MaterialFamily::kStone, 1.6f, BlackMarble},
    {"brown_granite", MaterialFamily::kStone, 0.8f, BrownGranite},
    {"concrete", MaterialFamily::kStone, 2.0f, Concrete},
    {"grey_granite", MaterialFamily::kStone, 0.8f, GreyGranite},
    {"limestone", MaterialFamily::kStone, 1.6f, Limestone},
    {"stone_wall", MaterialFamily::kStone, 1.6f, StoneWall},
    {"terrazzo", MaterialFamily::kStone, 1.0f, Terrazzo},
    {"white_marble", MaterialFamily::kStone, 1.6f, WhiteMarble},
};

}  // namespace

std::span<const MaterialRecipe> Stones() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
