// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kHalf = 0.3f;
constexpr float kTop = 0.86f;
constexpr float kFront = 0.56f;

/// Round door of a drum, on the front.
void Porthole(PieceMaker& m, const Surface& ring, const Surface& pane, float radius) {
  const Frame frame(&m, Turned({0, 0.43f, kFront}, 0.0f, kQuarterTurn));
  m.Turn(ring, {0, 0, 0},
         {{radius, 0.0f}, {radius, 0.025f}, {0.86f * radius, 0.04f}, {0.76f * radius, 0.035f}}, 16);
  m.Turn(pane, {0, 0.012f, 0}, {{0.78f * radius, 0.02f}, {0.45f * radius, 0.0f}, {0.0f, -0.004f}},
         16);
}

void Housing(PieceMaker& m, const Surface& body) {
  m.Box(kDark, {-kHalf + 0.03f, 0, 0.03f}, {kHalf - 0.03f, 0.05f, kFront - 0.05f});
  m.Box(body, {-kHalf + 0.004f, 0.03f, 0}, {kHalf - 0.004f, kTop, kFront});
  m.AddTop(kTop, {-kHalf, 0.0f}, {kHalf, kFront});
}

/// Control panel along the upper edge with a dial and a display.
void Controls(PieceMaker& m, const Surface& panel, float dial) {
  m.Box(panel, {-kHalf + 0.01f, 0.73f, kFront}, {kHalf - 0.01f, 0.845f, kFront + 0.012f});
  {
    const Frame frame(&m, Turned({dial, 0.787f, kFront + 0.012f}, 0.0f, kQuarterTurn));
    m.Cylinder(kChrome, {0, 0, 0}, 0.034f, 0.03f, 10);
  }
  Sheet(m, kDark, {dial + 0.14f, 0.765f, kFront + 0.015f}, 0.11f, 0.045f);
}

void WashingMachine(PieceMaker& m) {
  const Surface& body = m.Chance(0.6) ? kWhiteEnamel : m.palette().appliance;
  Housing(m, body);
  Controls(m, m.Chance(0.5) ? Shaded(body, 0.82f) : body, 0.02f);
  m.Box(Shaded(body, 0.9f), {-kHalf + 0.025f, 0.74f, kFront + 0.012f},
        {-0.08f, 0.835f, kFront + 0.02f});
  const Surface ring = m.Chance(0.6) ? kChrome : kGreyPlastic;
  Porthole(m, ring, {"glass", {52, 60, 70}}, m.Draw(0.18f, 0.21f));
  m.Box(Shaded(body, 0.85f), {0.12f, 0.07f, kFront}, {0.25f, 0.17f, kFront + 0.006f});
}

void Dryer(PieceMaker& m) {
  const Surface& body = m.Chance(0.6) ? kWhiteEnamel : m.palette().appliance;
  Housing(m, body);
  const Surface panel = m.Chance(0.5) ? kGreyPlastic : kBlackPlastic;
  Controls(m, panel, m.Chance(0.5) ? -0.16f : 0.0f);
  const Surface ring = m.Chance(0.7) ? body : kGreyPlastic;
  Porthole(m, ring, kGreyPlastic, m.Draw(0.21f, 0.24f));
  m.Box(Shaded(body, 0.75f), {-0.25f, 0.06f, kFront}, {0.25f, 0.13f, kFront + 0.006f});
}

/// Garments heaped on `at`.
void Heap(PieceMaker& m, const Vec& at, float radius) {
  for (int i = 0; i < 4; ++i) {
    const Vec2 shift = radius * m.Draw(Vec2(-0.4f, -0.4f), Vec2(0.4f, 0.4f));
    const float tilt = m.Draw(-0.25f, 0.25f);
    const Frame frame(&m, Turned(at + Vec(shift.x(), 0, shift.y()), m.Draw(0.0f, 3.0f), tilt));
    Pillow(m, {"linen", m.Chance(0.5) ? MutedColor(m) : Rgb8{240, 238, 232}},
           {-0.7f * radius, -0.06f, -0.55f * radius}, {0.7f * radius, 0.1f, 0.55f * radius});
  }
}

void LaundryBasket(PieceMaker& m) {
  const float radius = m.Draw(0.2f, 0.25f);
  const float height = m.Draw(0.4f, 0.58f);
  const Surface basket = m.Chance(0.7) ? kWicker : kWhitePlastic;
  if (m.Chance(0.5)) {
    m.Turn(basket, {0, 0, 0},
           {{0.8f * radius, 0.0f},
            {radius, height},
            {0.9f * radius, height},
            {0.85f * radius, 0.7f * height}},
           12);
    m.Turn(kDark, {0, 0.7f * height, 0}, {{0.85f * radius, 0.0f}, {0.0f, 0.0f}}, 12);
  } else {
    m.TaperedBox(basket, {0, 0, 0}, {1.7f * radius, 1.4f * radius}, {0, height, 0},
                 {2.0f * radius, 1.7f * radius});
  }
  Heap(m, {0, 0.97f * height, 0}, 0.8f * radius);
}

void IroningBoard(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.05f));
  constexpr float kHeight = 0.88f;
  const Surface cover{"checked_bedding", m.palette().accent.tint};
  const std::array<Vec2, 6> outline = {Vec2(-0.62f, -0.17f), Vec2(0.35f, -0.17f),
                                       Vec2(0.62f, -0.06f),  Vec2(0.62f, 0.06f),
                                       Vec2(0.35f, 0.17f),   Vec2(-0.62f, 0.17f)};
  m.Prism(cover, outline, kHeight - 0.03f, kHeight);
  for (const float z : {-0.14f, 0.14f}) {
    m.Bar(kGreyPlastic, {-0.42f, 0.019f, z}, {0.32f, kHeight - 0.03f, 0.5f * z}, 0.019f, 4);
    m.Bar(kGreyPlastic, {0.42f, 0.019f, z}, {-0.32f, kHeight - 0.03f, 0.5f * z}, 0.019f, 4);
  }
  for (const float x : {-0.42f, 0.42f})
    m.Bar(kGreyPlastic, {x, 0.019f, -0.16f}, {x, 0.019f, 0.16f}, 0.019f, 4);
  // The iron.
  const Surface shell{"plastic", BrightColor(m)};
  m.TaperedBox(kSteel, {-0.4f, kHeight, 0}, {0.24f, 0.11f}, {-0.4f, kHeight + 0.02f, 0},
               {0.24f, 0.11f});
  m.TaperedBox(shell, {-0.4f, kHeight + 0.02f, 0}, {0.23f, 0.1f}, {-0.43f, kHeight + 0.08f, 0},
               {0.14f, 0.07f});
  m.Box(shell, {-0.5f, kHeight + 0.11f, -0.015f}, {-0.34f, kHeight + 0.14f, 0.015f});
  m.Box(shell, {-0.5f, kHeight + 0.07f, -0.015f}, {-0.47f, kHeight + 0.11f, 0.015f});
}

void DryingRack(PieceMaker& m) {
  constexpr float kHeight = 0.95f;
  const Surface metal = m.Chance(0.5) ? kWhiteEnamel : kSteel;
  for (const float x : {-0.55f, 0.55f}) {
    m.Bar(metal, {x, 0.016f, -0.3f}, {x, kHeight, 0.25f}, 0.016f, 4);
    m.Bar(metal, {x, 0.016f, 0.3f}, {x, kHeight, -0.25f}, 0.016f, 4);
    m.Bar(metal, {x, kHeight, -0.28f}, {x, kHeight, 0.28f}, 0.012f, 4);
  }
  for (int i = 0; i < 5; ++i) {
    const float z = -0.26f + 0.13f * static_cast<float>(i);
    m.Bar(metal, {-0.55f, kHeight, z}, {0.55f, kHeight, z}, 0.008f, 4);
    if (i % 2 == 1) continue;
    float x = -0.5f;
    while (x < 0.3f) {
      const float width = m.Draw(0.2f, 0.42f);
      m.Box({"linen", m.Chance(0.6) ? MutedColor(m) : Rgb8{242, 240, 235}},
            {x, kHeight - m.Draw(0.3f, 0.55f), z - 0.012f},
            {std::min(x + width, 0.53f), kHeight + 0.012f, z + 0.012f});
      x += width + m.Draw(0.02f, 0.12f);
    }
  }
}

void Boiler(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.1f));
  if (m.Chance(0.5)) {
    m.RoundedBox(kWhiteEnamel, {-0.22f, 0.12f, 0}, {0.22f, 0.85f, 0.32f}, 0.03f);
    Sheet(m, kGreyPlastic, {0, 0.2f, 0.323f}, 0.26f, 0.07f);
  } else {
    m.Cylinder(kWhiteEnamel, {0, 0.12f, 0.21f}, 0.2f, 0.75f, 14);
    m.Cone(kWhiteEnamel, {0, 0.87f, 0.21f}, 0.2f, 0.11f, 0.06f, 14);
  }
  for (const float x : {-0.1f, 0.0f, 0.1f})
    m.Bar({"copper"}, {x, 0.0f, 0.15f}, {x, 0.15f, 0.15f}, 0.014f, 5);
}

/// Broom and mop in the corner, with their bucket.
void CleaningSet(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.06f));
  const Surface bucket{"plastic", BrightColor(m)};
  m.Turn(bucket, {0, 0, 0.22f}, {{0.11f, 0.0f}, {0.15f, 0.28f}, {0.14f, 0.28f}, {0.12f, 0.15f}},
         10);
  m.Turn({"glass", {150, 180, 190}}, {0, 0.15f, 0.22f}, {{0.125f, 0.0f}, {0.0f, 0.0f}}, 10);
  const Surface& wood = m.palette().wood;
  m.Bar(wood, {-0.2f, 0.1f, 0.2f}, {-0.12f, 1.35f, 0.03f}, 0.018f, 5);
  m.TaperedBox({"wicker", {255, 226, 150}}, {-0.21f, 0.0f, 0.22f}, {0.26f, 0.08f},
               {-0.2f, 0.16f, 0.2f}, {0.12f, 0.05f});
  m.Bar(wood, {0.02f, 0.14f, 0.2f}, {0.16f, 1.38f, 0.03f}, 0.018f, 5);
  m.Ball({"terry_towel", {225, 225, 215}}, {0.02f, 0.2f, 0.21f}, {0.08f, 0.1f, 0.08f}, 6);
}

constexpr std::array kKinds = {
    FurnitureKind{"boiler", Placement::kOnWall, 0.3f, Boiler},
    FurnitureKind{"cleaning_set", Placement::kAgainstWall, 0.1f, CleaningSet},
    FurnitureKind{"dryer", Placement::kAgainstWall, 0.7f, Dryer},
    FurnitureKind{"drying_rack", Placement::kFree, 0.3f, DryingRack},
    FurnitureKind{"ironing_board", Placement::kFree, 0.4f, IroningBoard},
    FurnitureKind{"laundry_basket", Placement::kFree, 0.2f, LaundryBasket},
    FurnitureKind{"washing_machine", Placement::kAgainstWall, 0.7f, WashingMachine}};

}  // namespace

std::span<const FurnitureKind> Laundry() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
