// SPDX-License-Identifier: MIT
// Vehicles that stand in workshops.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// The side view of a body, front to +x: points (x as a share of half the length, y in metres).
struct Shape {
  float bonnet = 0.45f;  // where the windscreen begins
  float roof0 = 0.1f;    // where the roof begins
  float roof1 = -0.6f;   // where it ends
  float tail = -0.95f;   // where the rear screen ends
  float sill = 0.9f;     // height under the panes
  float top = 1.45f;
};

Shape DrawShape(PieceMaker& m) {
  if (m.Chance(0.35)) return {0.8f, 0.55f, -0.96f, -0.99f, 1.1f, m.Draw(1.75f, 1.95f)};  // a van
  if (m.Chance(0.5)) return {0.42f, 0.08f, -0.72f, -0.95f, 0.92f, m.Draw(1.42f, 1.6f)};
  return {0.36f, 0.05f, -0.42f, -0.7f, 0.88f, m.Draw(1.36f, 1.45f)};
}

void Wheels(PieceMaker& m, float half, float wide) {
  for (const float x : {-0.6f * half, 0.62f * half}) {
    for (const float side : {-1.0f, 1.0f}) {
      const float outer = side * wide;
      const float inner = side * (wide - 0.2f);
      m.Bar(kRubber, {x, 0.31f, inner}, {x, 0.31f, outer}, 0.31f, 14);
      m.Bar(kSteel, {x, 0.31f, outer}, {x, 0.31f, outer + side * 0.01f}, 0.18f, 10);
    }
  }
}

/// The upper part with its panes: from the sill to the roof, narrower above.
void Cabin(PieceMaker& m, const Surface& paint, const Shape& s, float half, float wide) {
  const float low = s.sill;
  const float in = 0.82f * wide;
  const std::array<Vec2, 4> line = {Vec2(s.bonnet * half, low), Vec2(s.roof0 * half, s.top),
                                    Vec2(s.roof1 * half, s.top), Vec2(s.tail * half, low)};
  const auto at = [&](std::size_t i, float side) {
    const bool is_roof = i == 1 || i == 2;
    return Vec(line[i].x(), line[i].y(), side * (is_roof ? in : wide));
  };
  const Surface pane{"glass", {70, 84, 92}};
  m.Quad(pane, at(0, 1), at(0, -1), at(1, -1), at(1, 1));   // the windscreen
  m.Quad(paint, at(1, 1), at(1, -1), at(2, -1), at(2, 1));  // the roof
  m.Quad(pane, at(2, 1), at(2, -1), at(3, -1), at(3, 1));
  m.Quad(pane, at(3, 1), at(0, 1), at(1, 1), at(2, 1));
  m.Quad(pane, at(0, -1), at(3, -1), at(2, -1), at(1, -1));
  for (const float side : {-1.0f, 1.0f}) {
    const float x = 0.5f * (s.roof0 + s.roof1) * half;
    m.Bar(paint, {x, low, side * wide}, {x, s.top, side * in}, 0.035f, 4);
    m.Bar(paint, at(0, side), at(1, side), 0.03f, 4);
    m.Bar(paint, at(2, side), at(3, side), 0.035f, 4);
  }
}

/// A car or a van, its front to +x.
void Car(PieceMaker& m) {
  const float half = 0.5f * m.Width(3.7f, 4.6f, 0.06f);
  const float wide = 0.5f * m.Draw(1.65f, 1.9f);
  const Shape shape = DrawShape(m);
  const std::array<Rgb8, 6> colors = {Rgb8{236, 238, 240}, Rgb8{60, 64, 70}, Rgb8{150, 30, 34},
                                      Rgb8{40, 70, 120},   MutedColor(m),    Rgb8{170, 174, 178}};
  const Surface paint{"painted_wood", m.rng().Pick(colors)};
  const Surface lower = Shaded(paint, 0.85f);
  m.Box(kDark, {-0.94f * half, 0.18f, -wide + 0.22f}, {0.94f * half, 0.4f, wide - 0.22f});
  m.Box(lower, {-half, 0.4f, -wide + 0.04f}, {half, 0.62f, wide - 0.04f});
  m.TaperedBox(paint, {0, 0.62f, 0}, {2.0f * half, 2.0f * wide - 0.08f}, {0, shape.sill, 0},
               {1.94f * half, 2.0f * wide - 0.12f});
  Cabin(m, paint, shape, half, wide - 0.08f);
  Wheels(m, half, wide - 0.02f);
  for (const float z : {-0.7f * wide, 0.7f * wide}) {
    m.Box(kWhitePlastic, {half, 0.56f, z - 0.14f}, {half + 0.02f, 0.7f, z + 0.14f});
    m.Box({"plastic", {180, 24, 24}}, {-half - 0.02f, 0.58f, z - 0.12f}, {-half, 0.72f, z + 0.12f});
  }
  for (const float x : {-half - 0.03f, half - 0.05f}) {
    m.Box(kBlackPlastic, {x, 0.3f, -0.9f * wide}, {x + 0.08f, 0.46f, 0.9f * wide});
  }
}

constexpr std::array kKinds = {FurnitureKind{"car", Placement::kFree, 0.6f, Car, 3.5f, 4.8f}};

}  // namespace

std::span<const FurnitureKind> Vehicles() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
