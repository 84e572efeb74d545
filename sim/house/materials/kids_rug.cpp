// SPDX-License-Identifier: MIT
// A play mat: a town of roads, houses, trees and a pond. Its roads go on over the seam.
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/weave.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kKerb = Hex(0xd6d4cc);
constexpr Color kRoad = Hex(0x87888c);
constexpr Color kPaint = Hex(0xfaf6e4);
constexpr Point kMiddle = {0.5f, 0.5f};

void PaintRoads(Canvas* canvas) {
  constexpr std::pair<Point, Point> kRoads[] = {{{-0.1f, 0.5f}, {0.34f, 0.5f}},
                                                {{0.66f, 0.5f}, {1.1f, 0.5f}},
                                                {{0.5f, -0.1f}, {0.5f, 0.34f}},
                                                {{0.5f, 0.66f}, {0.5f, 1.1f}}};
  for (const auto& [a, b] : kRoads) {
    canvas->Paint(Stroke{a, b, 0.105f}, kKerb);
    canvas->Paint(Stroke{a, b, 0.09f}, kRoad);
  }
  canvas->Paint(Ring{kMiddle, 0.16f, 0.105f}, kKerb);
  canvas->Paint(Ring{kMiddle, 0.16f, 0.09f}, kRoad);
  constexpr int kDashes = 12;
  for (int i = 0; i < kDashes; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / kDashes;
    if (std::abs(t - 0.5f) < 0.19f) continue;
    canvas->Paint(Rect{{t - 0.02f, 0.495f}, {t + 0.02f, 0.505f}}, kPaint);
    canvas->Paint(Rect{{0.495f, t - 0.02f}, {0.505f, t + 0.02f}}, kPaint);
  }
  PaintFlower(canvas, kMiddle, 0.085f, 0.0f, {8, Hex(0xf0d04c), Hex(0xe07a4c)});
}

void PaintCottage(Canvas* canvas, Point p, Color wall, Color roof) {
  canvas->Paint(Rect{p - Point{0.055f, 0.0f}, p + Point{0.055f, 0.09f}}, wall);
  canvas->Paint(
      Polygon{p + Point{-0.075f, 0.0f}, p + Point{0.0f, -0.075f}, p + Point{0.075f, 0.0f}}, roof);
  canvas->Paint(Rect{p + Point{-0.016f, 0.035f}, p + Point{0.016f, 0.09f}}, roof);
}

/// Seen from above; `half` is half its length and width.
void PaintCar(Canvas* canvas, Point p, Point half, Color paint) {
  canvas->Paint(Rect{p - half, p + half, 0.012f}, paint);
  canvas->Paint(Rect{p - half * 0.5f, p + half * 0.5f, 0.004f}, Hex(0xcfe6f2));
}

void PaintParks(Canvas* canvas) {
  canvas->Paint(Ellipse{{0.21f, 0.21f}, {0.14f, 0.1f}, -0.5f}, Hex(0xdcc98f));
  canvas->Paint(Ellipse{{0.21f, 0.21f}, {0.12f, 0.082f}, -0.5f}, Hex(0x62b2dc));
  constexpr Point kTrees[] = {{0.38f, 0.09f}, {0.34f, 0.3f},  {0.08f, 0.37f},
                              {0.64f, 0.33f}, {0.32f, 0.68f}, {0.36f, 0.9f},
                              {0.07f, 0.93f}, {0.66f, 0.68f}, {0.63f, 0.1f}};
  for (const Point& tree : kTrees) {
    canvas->Paint(Disc(tree, 0.04f), Hex(0x3f8f4a));
    canvas->Paint(Disc(tree - Point{0.008f, 0.01f}, 0.026f), Hex(0x5bad58));
  }
  // A playing field.
  canvas->Paint(Rect{{0.7f, 0.7f}, {0.94f, 0.9f}, 0.01f}, Hex(0x6fae55));
  canvas->Paint(Ring{{0.82f, 0.8f}, 0.04f, 0.008f}, kPaint);
  canvas->Paint(Rect{{0.816f, 0.7f}, {0.824f, 0.9f}}, kPaint);
}

Image PlayMat() {
  Canvas canvas(Hex(0x8fc46d));
  PaintRoads(&canvas);
  PaintParks(&canvas);
  PaintCottage(&canvas, {0.76f, 0.17f}, Hex(0xf4e3b5), Hex(0xd5503f));
  PaintCottage(&canvas, {0.9f, 0.28f}, Hex(0xf2f2f2), Hex(0x4a7fc4));
  PaintCottage(&canvas, {0.17f, 0.76f}, Hex(0xf0b5a0), Hex(0x8a5a3c));
  PaintCar(&canvas, {0.14f, 0.475f}, {0.035f, 0.018f}, Hex(0xd9443a));
  PaintCar(&canvas, {0.86f, 0.525f}, {0.035f, 0.018f}, Hex(0x3b6fc9));
  PaintCar(&canvas, {0.525f, 0.12f}, {0.018f, 0.035f}, Hex(0xf2c230));
  canvas.Shade([](Point p, Color c) {
    return c * WoolPile(p);
  });
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"kids_rug", MaterialFamily::kCarpet, 1.6f, PlayMat},
};

}  // namespace

std::span<const MaterialRecipe> PlayMats() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
