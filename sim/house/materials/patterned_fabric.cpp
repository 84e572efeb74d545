// SPDX-License-Identifier: MIT
// Cloth with a pattern in greys on white: one tint colours both.
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kGround = Hex(0xf3f1ed);
constexpr Color kInk = Hex(0x9a9896);

/// 1 where x, in periods, is in a stripe of this share of the period centred on whole numbers.
float Stripe(float x, float share, float fade) {
  const float far = std::abs(Fraction(x + 0.5f) - 0.5f);
  return Smooth(0.5f * share + fade, 0.5f * share - fade, far);
}

/// Gingham: stripes of warp and weft that darken where they cross.
Image CheckedBedding() {
  return Shaded([](Point p) {
    const float across = Stripe(5.0f * p.x + 0.5f, 0.5f, 0.02f);
    const float down = Stripe(5.0f * p.y + 0.5f, 0.5f, 0.02f);
    return Mix(kGround, kInk, 0.46f * (across + down)) * Slubs(p, 0.02f, 1);
  });
}

/// Tartan: broad bands with thin lines beside and between them, both ways.
Image Plaid() {
  const auto sett = [](float x) {
    const float broad = 0.5f * Stripe(2.0f * x, 0.36f, 0.008f);
    const float narrow = 0.5f * Stripe(2.0f * x + 0.5f, 0.1f, 0.008f);
    const float line = 0.55f * (Stripe(2.0f * x + 0.37f, 0.024f, 0.008f) +
                                Stripe(2.0f * x + 0.63f, 0.024f, 0.008f));
    const float light = 0.45f * Stripe(2.0f * x, 0.05f, 0.008f);
    return broad + narrow + line - light;
  };
  return Shaded([&](Point p) {
    const float depth = 0.75f * (sett(p.x) + sett(p.y));
    return Mix(kGround, Hex(0x7c7a79), depth) * Twill(p, 64);
  });
}

Image StripedCotton() {
  return Shaded([](Point p) {
    const float broad = Stripe(4.0f * p.x + 0.5f, 0.42f, 0.015f);
    const float pins =
        Stripe(4.0f * p.x + 0.12f, 0.05f, 0.015f) + Stripe(4.0f * p.x - 0.12f, 0.05f, 0.015f);
    return Mix(kGround, kInk, 0.9f * broad + 0.7f * pins) * Slubs(p, 0.025f, 1);
  });
}

Image DottedFabric() {
  Canvas canvas(kGround);
  constexpr int kRows = 8;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kRows / 2; ++i) {
      const float x = (2.0f * static_cast<float>(i) + (row % 2 == 0 ? 0.5f : 1.5f)) / kRows;
      canvas.Paint(Disc({x, (static_cast<float>(row) + 0.5f) / kRows}, 0.038f), kInk);
    }
  }
  canvas.Shade([](Point p, Color c) {
    return c * Slubs(p, 0.025f, 1);
  });
  return canvas.Finish();
}

/// Flowers on a jittered grid, their leaves under all of them.
Image FloralFabric() {
  struct Spot {
    Point centre;
    float size = 0.0f;
    float angle = 0.0f;
  };
  Rng rng(0, "floral_fabric");
  constexpr int kCells = 4;
  std::vector<Spot> spots;
  for (int i = 0; i < kCells * kCells; ++i) {
    const Point cell =
        CellOf(i, kCells) + Point{Between(rng, 0.3f, 0.7f), Between(rng, 0.3f, 0.7f)};
    const bool large = (i + i / kCells) % 2 == 0;
    spots.push_back({cell * (1.0f / kCells), large ? 0.1f : 0.055f, Between(rng, 0.0f, 6.28f)});
  }
  Canvas canvas(kGround);
  for (const auto& [centre, size, angle] : spots) {
    PaintFrond(&canvas, centre, centre + Turned({0.0f, 1.9f * size}, angle), 4, Hex(0xb9b7b3));
    PaintFrond(&canvas, centre, centre + Turned({0.0f, -1.7f * size}, angle + 0.5f), 3,
               Hex(0xc4c2be));
  }
  for (const auto& [centre, size, angle] : spots) {
    PaintFlower(&canvas, centre, size, angle, {size > 0.08f ? 7 : 5, Hex(0x9f9d9b), Hex(0xe8e6e2)});
  }
  canvas.Shade([](Point p, Color c) {
    return c * Slubs(p, 0.02f, 1);
  });
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"checked_bedding", MaterialFamily::kFabric, 0.5f, CheckedBedding},
    {"dotted_fabric", MaterialFamily::kFabric, 0.4f, DottedFabric},
    {"floral_fabric", MaterialFamily::kFabric, 0.6f, FloralFabric},
    {"plaid", MaterialFamily::kFabric, 0.6f, Plaid},
    {"striped_cotton", MaterialFamily::kFabric, 0.5f, StripedCotton},
};

}  // namespace

std::span<const MaterialRecipe> PatternedFabrics() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
