// SPDX-License-Identifier: MIT
// A carpet with borders, corners and a medallion: best shown once, though its edges fit together.
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

// Colours of old dyes.
constexpr Color kMadder = Hex(0xa4473c);
constexpr Color kIndigo = Hex(0x34496b);
constexpr Color kIvory = Hex(0xeadfc6);
constexpr Color kGold = Hex(0xcfa158);
constexpr Color kSage = Hex(0x7f9277);

/// Paints a motif at the four places that mirror images of the rug put it.
template <class Motif>
void FourTimes(Point p, const Motif& motif) {
  for (const float x : {p.x, 1.0f - p.x}) {
    for (const float y : {p.y, 1.0f - p.y}) motif(Point{x, y});
  }
}

/// Guard stripes, border and field, by distance from the rug's edge.
Color Ground(Point p) {
  const float in = std::min(std::min(p.x, 1.0f - p.x), std::min(p.y, 1.0f - p.y));
  constexpr std::pair<float, Color> kBands[] = {
      {0.02f, kIndigo}, {0.035f, kGold}, {0.05f, kMadder},  {0.06f, kIvory},
      {0.16f, kIndigo}, {0.17f, kIvory}, {0.185f, kMadder}, {0.197f, kGold}};
  Color color = kMadder;
  for (std::size_t i = std::size(kBands); i-- > 0;) {
    color = Mix(kBands[i].second, color,
                Smooth(kBands[i].first - 0.002f, kBands[i].first + 0.002f, in));
  }
  return color;
}

/// The same for a point on the border: on all four sides, `along` from a corner.
template <class Motif>
void OnBorder(float along, const Motif& motif) {
  for (const float side : {0.11f, 0.89f}) {
    motif(Point{along, side});
    motif(Point{side, along});
  }
}

void PaintBorder(Canvas* canvas) {
  constexpr int kRosettes = 9;
  constexpr float kPitch = 0.78f / (kRosettes - 1);
  for (int i = 0; i < kRosettes; ++i) {
    const float along = 0.11f + kPitch * static_cast<float>(i);
    OnBorder(along, [&](Point p) {
      PaintFlower(canvas, p, 0.036f, 0.0f, {8, i % 2 == 0 ? kMadder : kGold, kIvory});
    });
    if (i + 1 == kRosettes) break;
    OnBorder(along + 0.5f * kPitch, [&](Point p) {
      canvas->Paint(Star(p, 4, {0.008f, 0.024f}), kSage);
      canvas->Paint(Disc(p, 0.008f), kIvory);
    });
  }
}

void PaintMedallion(Canvas* canvas) {
  const Point middle = {0.5f, 0.5f};
  // Pendants above and below, then star upon star.
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(
        Leaf{middle + Point{0.0f, side * 0.16f}, middle + Point{0.0f, side * 0.29f}, 0.06f},
        kIndigo);
    canvas->Paint(Disc(middle + Point{0.0f, side * 0.225f}, 0.014f), kGold);
  }
  canvas->Paint(Star(middle, 16, {0.165f, 0.19f}), kIvory);
  canvas->Paint(Star(middle, 16, {0.152f, 0.176f}), kIndigo);
  canvas->Paint(Star(middle, 8, {0.095f, 0.135f}), kGold);
  canvas->Paint(Star(middle, 8, {0.085f, 0.122f}), kMadder);
  PaintFlower(canvas, middle, 0.088f, 0.0f, {8, kIvory, kIndigo});
  PaintFlower(canvas, middle, 0.042f, 0.39f, {8, kGold, kMadder});
  for (int i = 0; i < 16; ++i) {
    canvas->Paint(
        Disc(middle + Turned({0.143f, 0.0f}, kPi * (static_cast<float>(i) + 0.5f) / 8.0f), 0.007f),
        kIvory);
  }
}

void PaintCorner(Canvas* canvas, Point p) {
  const Point towards = {p.x < 0.5f ? 1.0f : -1.0f, p.y < 0.5f ? 1.0f : -1.0f};
  const auto at = [&](float x, float y) {
    return p + Point{x * towards.x, y * towards.y};
  };
  canvas->Paint(Polygon{p, at(0.15f, 0.0f), at(0.1f, 0.04f), at(0.08f, 0.08f), at(0.04f, 0.1f),
                        at(0.0f, 0.15f)},
                kIndigo);
  PaintFlower(canvas, at(0.042f, 0.042f), 0.03f, 0.0f, {8, kIvory, kGold});
}

/// Three leaves around a flower.
void PaintSpray(Canvas* canvas, Point p, float radius, float angle, Color petal) {
  for (const float turn : {angle, angle + 2.1f, angle + 4.2f}) {
    canvas->Paint(Leaf{p, p + Turned({0.048f, 0.0f}, turn), 0.014f}, kSage);
  }
  PaintFlower(canvas, p, radius, angle, {6, petal, kIndigo});
}

/// Corner pieces, and sprays of flowers between them and the medallion.
void PaintField(Canvas* canvas) {
  FourTimes({0.197f, 0.197f}, [&](Point p) {
    PaintCorner(canvas, p);
  });
  Rng rng(0, "persian_rug");
  constexpr Color kPetals[] = {kIvory, kGold, kSage};
  constexpr Point kFlowers[] = {{0.25f, 0.4f}, {0.33f, 0.31f}, {0.42f, 0.25f},
                                {0.27f, 0.5f}, {0.5f, 0.237f}, {0.36f, 0.4f}};
  for (const Point& at : kFlowers) {
    const float radius = Between(rng, 0.018f, 0.028f);
    const Color petal = OneOf(rng, kPetals);
    const float angle = Between(rng, 0.0f, 1.0f);
    FourTimes(at, [&](Point p) {
      PaintSpray(canvas, p, radius, angle, petal);
    });
  }
}

Image Persian() {
  Canvas canvas(kMadder, Edge::kClip);
  canvas.Shade(Ground);
  PaintBorder(&canvas);
  PaintField(&canvas);
  PaintMedallion(&canvas);
  canvas.Shade([](Point p, Color c) {
    return c * WoolPile(p);
  });
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"persian_rug", MaterialFamily::kCarpet, 2.0f, Persian},
};

}  // namespace

std::span<const MaterialRecipe> PersianRugs() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
