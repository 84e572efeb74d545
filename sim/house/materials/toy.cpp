// SPDX-License-Identifier: MIT
// A shelf of toys. Shown once.
#include "sim/base/elementary.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kRed = Hex(0xdd4a43);
constexpr Color kBlue = Hex(0x3f83cf);
constexpr Color kYellow = Hex(0xf3c93f);
constexpr Color kGreen = Hex(0x5bb368);
constexpr float kFloor = 0.985f;

void PaintBear(Canvas* canvas, Point seat, float size) {
  const Color fur = Hex(0xb9834f);
  const auto disc = [&](float x, float y, float radius, Color color) {
    canvas->Paint(Disc(seat + Point{x, y} * size, radius * size), color);
  };
  for (const float side : {-1.0f, 1.0f}) {
    disc(0.3f * side, -0.1f, 0.17f, fur * 0.9f);
    disc(0.34f * side, -0.09f, 0.09f, fur * 1.25f);
    disc(0.3f * side, -0.5f, 0.12f, fur * 0.92f);
    disc(0.23f * side, -1.0f, 0.11f, fur * 0.9f);
  }
  disc(0.0f, -0.36f, 0.31f, fur);
  disc(0.0f, -0.33f, 0.19f, fur * 1.22f);
  disc(0.0f, -0.83f, 0.27f, fur * 1.03f);
  disc(0.0f, -0.76f, 0.12f, fur * 1.28f);
  disc(0.0f, -0.8f, 0.04f, Hex(0x3a2a20));
  disc(-0.1f, -0.9f, 0.03f, Hex(0x2a2018));
  disc(0.1f, -0.9f, 0.03f, Hex(0x2a2018));
}

/// A cube with a letter-like mark.
void PaintBlock(Canvas* canvas, Point low, float side, Color color) {
  canvas->Paint(Rect{low, low + Point{side, side}, 0.008f}, color);
  canvas->Paint(Rect{low + Point{side, side} * 0.14f, low + Point{side, side} * 0.86f, 0.006f},
                Hex(0xfaf3e0));
  canvas->Paint(Ring{low + Point{side, side} * 0.5f, 0.18f * side, 0.12f * side}, color);
}

void PaintTruck(Canvas* canvas, Point p) {
  canvas->Paint(Rect{p + Point{0.0f, -0.17f}, p + Point{0.15f, -0.05f}, 0.01f}, kYellow);
  canvas->Paint(Rect{p + Point{0.155f, -0.2f}, p + Point{0.235f, -0.05f}, 0.02f}, kRed);
  canvas->Paint(Rect{p + Point{0.175f, -0.18f}, p + Point{0.225f, -0.12f}, 0.008f}, Hex(0xd5ecf6));
  canvas->Paint(Rect{p + Point{-0.005f, -0.07f}, p + Point{0.24f, -0.045f}}, Hex(0x55585c));
  for (const float x : {0.045f, 0.185f}) {
    canvas->Paint(Disc(p + Point{x, -0.035f}, 0.035f), Hex(0x38383b));
    canvas->Paint(Disc(p + Point{x, -0.035f}, 0.015f), Hex(0xd8d8d8));
  }
}

void PaintRings(Canvas* canvas, float x) {
  constexpr Color kColors[] = {kBlue, kGreen, kYellow, kRed};
  canvas->Paint(Stroke{{x, kFloor}, {x, 0.6f}, 0.02f}, Hex(0xe6cfa4));
  for (std::size_t i = 0; i < std::size(kColors); ++i) {
    const float y = kFloor - 0.045f - 0.075f * static_cast<float>(i);
    const float half = 0.085f - 0.014f * static_cast<float>(i);
    canvas->Paint(Rect{{x - half, y - 0.036f}, {x + half, y + 0.036f}, 0.034f}, [&](Point p) {
      return kColors[i] * (1.1f - 0.35f * (p.y - y + 0.036f) / 0.072f);
    });
  }
}

Image Toys() {
  Canvas canvas(Hex(0xe3dccf), Edge::kClip);
  canvas.Shade([](Point p) {
    return Hex(0xe0d8ca) * Mix(0.76f, 1.0f, Smooth(0.0f, 0.4f, p.y));
  });
  PaintBear(&canvas, {0.15f, kFloor}, 0.5f);
  PaintBlock(&canvas, {0.29f, kFloor - 0.13f}, 0.13f, kBlue);
  PaintBlock(&canvas, {0.425f, kFloor - 0.13f}, 0.13f, kRed);
  PaintBlock(&canvas, {0.355f, kFloor - 0.262f}, 0.13f, kGreen);
  PaintBlock(&canvas, {0.36f, kFloor - 0.394f}, 0.13f, kYellow);
  PaintTruck(&canvas, {0.55f, kFloor});
  // A box with a picture on top of which nothing stands, and a ball before it.
  canvas.Paint(Rect{{0.57f, 0.34f}, {0.77f, 0.76f}, 0.01f}, Hex(0x8f6ac0));
  PaintFlower(&canvas, {0.67f, 0.53f}, 0.08f, 0.0f, {5, kYellow, kRed});
  PaintRings(&canvas, 0.9f);
  const Point ball = {0.9f, 0.47f};
  canvas.Paint(Disc(ball, 0.095f), [&](Point p) {
    const Point d = p - ball;
    const float sector = Fraction(Atan2(d.y, d.x) / (2.0f * kPi)) * 6.0f;
    const Color color = static_cast<int>(sector) % 2 == 0   ? Hex(0xfaf6ea)
                        : static_cast<int>(sector) % 3 == 0 ? kRed
                                                            : kBlue;
    return color * (1.05f - 2.2f * Length(d + Point{0.03f, 0.04f}));
  });
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"toys", MaterialFamily::kOther, 1.0f, Toys, false},
};

}  // namespace

std::span<const MaterialRecipe> Toys() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
