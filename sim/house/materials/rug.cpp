// SPDX-License-Identifier: MIT
// Patterned rugs.
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

/// The wool itself, over a finished drawing.
void Knot(Canvas* canvas) {
  canvas->Shade([](Point p, Color c) {
    return c * (1.0f + 0.05f * Noise(p, {128, 128, 71}) + 0.04f * Noise(p, {3, 40, 72}));
  });
}

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
Color PersianGround(Point p) {
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

void PersianBorder(Canvas* canvas) {
  constexpr int kRosettes = 9;
  for (int i = 0; i < kRosettes; ++i) {
    const float along = Mix(0.11f, 0.89f, static_cast<float>(i) / (kRosettes - 1));
    const float next = along + 0.5f * 0.78f / (kRosettes - 1);
    for (const float side : {0.11f, 0.89f}) {
      for (const bool level : {false, true}) {
        const auto place = [&](float t) {
          return level ? Point{t, side} : Point{side, t};
        };
        PaintFlower(canvas, place(along), 0.036f, 0.0f, {8, i % 2 == 0 ? kMadder : kGold, kIvory});
        if (i + 1 == kRosettes) continue;
        canvas->Paint(Star(place(next), 4, {0.008f, 0.024f}), kSage);
        canvas->Paint(Disc(place(next), 0.008f), kIvory);
      }
    }
  }
}

void PersianMedallion(Canvas* canvas) {
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

Image Persian() {
  Canvas canvas(kMadder, Edge::kClip);
  canvas.Shade(PersianGround);
  PersianBorder(&canvas);
  // Corner pieces, then vines and flowers in the field.
  FourTimes({0.197f, 0.197f}, [&](Point p) {
    const Point towards = {p.x < 0.5f ? 1.0f : -1.0f, p.y < 0.5f ? 1.0f : -1.0f};
    canvas.Paint(
        Polygon{p, p + Point{0.15f * towards.x, 0.0f},
                p + Point{0.1f * towards.x, 0.04f * towards.y},
                p + Point{0.08f * towards.x, 0.08f * towards.y},
                p + Point{0.04f * towards.x, 0.1f * towards.y}, p + Point{0.0f, 0.15f * towards.y}},
        kIndigo);
    PaintFlower(&canvas, p + towards * 0.042f, 0.03f, 0.0f, {8, kIvory, kGold});
  });
  Rng rng(0, "persian_rug");
  constexpr Point kFlowers[] = {{0.25f, 0.4f}, {0.33f, 0.31f}, {0.42f, 0.25f},
                                {0.27f, 0.5f}, {0.5f, 0.237f}, {0.36f, 0.4f}};
  for (const Point& at : kFlowers) {
    const float radius = Between(rng, 0.018f, 0.028f);
    const Color petal = OneOf(rng, std::array{kIvory, kGold, kSage});
    const float angle = Between(rng, 0.0f, 1.0f);
    FourTimes(at, [&](Point p) {
      for (const float turn : {angle, angle + 2.1f, angle + 4.2f}) {
        const Point tip = p + Turned({0.048f, 0.0f}, turn);
        canvas.Paint(Leaf{p, tip, 0.014f}, kSage);
      }
      PaintFlower(&canvas, p, radius, angle, {6, petal, kIndigo});
    });
  }
  PersianMedallion(&canvas);
  Knot(&canvas);
  return canvas.Finish();
}

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
    const Point q = {(std::floor(p.x * kThreads) + 0.5f) / kThreads,
                     (std::floor(p.y * kThreads) + 0.5f) / kThreads};
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

/// A play mat: a town of roads, houses, trees and a pond. Its roads go on over the seam.
Image Kids() {
  constexpr Color kGrass = Hex(0x8fc46d);
  constexpr Color kRoad = Hex(0x87888c);
  Canvas canvas(kGrass);
  const auto road = [&](Point a, Point b) {
    canvas.Paint(Stroke{a, b, 0.105f}, Hex(0xd6d4cc));
    canvas.Paint(Stroke{a, b, 0.09f}, kRoad);
  };
  const Ring roundabout = {{0.5f, 0.5f}, 0.16f, 0.09f};
  road({-0.1f, 0.5f}, {0.34f, 0.5f});
  road({0.66f, 0.5f}, {1.1f, 0.5f});
  road({0.5f, -0.1f}, {0.5f, 0.34f});
  road({0.5f, 0.66f}, {0.5f, 1.1f});
  canvas.Paint(Ring{{0.5f, 0.5f}, 0.16f, 0.105f}, Hex(0xd6d4cc));
  canvas.Paint(roundabout, kRoad);
  for (int i = 0; i < 12; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / 12.0f;
    if (std::abs(t - 0.5f) < 0.19f) continue;
    canvas.Paint(Rect{{t - 0.02f, 0.495f}, {t + 0.02f, 0.505f}}, Hex(0xfaf6e4));
    canvas.Paint(Rect{{0.495f, t - 0.02f}, {0.505f, t + 0.02f}}, Hex(0xfaf6e4));
  }
  PaintFlower(&canvas, {0.5f, 0.5f}, 0.085f, 0.0f, {8, Hex(0xf0d04c), Hex(0xe07a4c)});
  canvas.Paint(Ellipse{{0.21f, 0.21f}, {0.14f, 0.1f}, -0.5f}, Hex(0xdcc98f));
  canvas.Paint(Ellipse{{0.21f, 0.21f}, {0.12f, 0.082f}, -0.5f}, Hex(0x62b2dc));
  const auto house = [&](Point p, Color wall, Color roof) {
    canvas.Paint(Rect{p - Point{0.055f, 0.0f}, p + Point{0.055f, 0.09f}}, wall);
    canvas.Paint(
        Polygon{p + Point{-0.075f, 0.0f}, p + Point{0.0f, -0.075f}, p + Point{0.075f, 0.0f}}, roof);
    canvas.Paint(Rect{p + Point{-0.016f, 0.035f}, p + Point{0.016f, 0.09f}}, roof);
  };
  house({0.76f, 0.17f}, Hex(0xf4e3b5), Hex(0xd5503f));
  house({0.9f, 0.28f}, Hex(0xf2f2f2), Hex(0x4a7fc4));
  house({0.17f, 0.76f}, Hex(0xf0b5a0), Hex(0x8a5a3c));
  constexpr Point kTrees[] = {{0.38f, 0.09f}, {0.34f, 0.3f},  {0.08f, 0.37f},
                              {0.64f, 0.33f}, {0.32f, 0.68f}, {0.36f, 0.9f},
                              {0.07f, 0.93f}, {0.66f, 0.68f}, {0.63f, 0.1f}};
  for (const Point& tree : kTrees) {
    canvas.Paint(Disc(tree, 0.04f), Hex(0x3f8f4a));
    canvas.Paint(Disc(tree - Point{0.008f, 0.01f}, 0.026f), Hex(0x5bad58));
  }
  // A playing field, and cars.
  canvas.Paint(Rect{{0.7f, 0.7f}, {0.94f, 0.9f}, 0.01f}, Hex(0x6fae55));
  canvas.Paint(Ring{{0.82f, 0.8f}, 0.04f, 0.008f}, Hex(0xf4f4ee));
  canvas.Paint(Rect{{0.816f, 0.7f}, {0.824f, 0.9f}}, Hex(0xf4f4ee));
  const auto car = [&](Point p, Color paint, bool level) {
    const Point half = level ? Point{0.035f, 0.018f} : Point{0.018f, 0.035f};
    canvas.Paint(Rect{p - half, p + half, 0.012f}, paint);
    canvas.Paint(Rect{p - half * 0.5f, p + half * 0.5f, 0.004f}, Hex(0xcfe6f2));
  };
  car({0.14f, 0.475f}, Hex(0xd9443a), true);
  car({0.86f, 0.525f}, Hex(0x3b6fc9), true);
  car({0.525f, 0.12f}, Hex(0xf2c230), false);
  Knot(&canvas);
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"geometric_rug", MaterialFamily::kCarpet, 1.2f, Geometric},
    {"kids_rug", MaterialFamily::kCarpet, 1.6f, Kids},
    {"persian_rug", MaterialFamily::kCarpet, 2.0f, Persian},
    {"striped_rug", MaterialFamily::kCarpet, 1.2f, Striped},
};

}  // namespace

std::span<const MaterialRecipe> Rugs() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
