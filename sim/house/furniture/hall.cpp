// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

Surface Cloth(PieceMaker& m) {
  static constexpr std::array<std::string_view, 3> kCloths = {"linen", "canvas", "wool_knit"};
  return {m.rng().Pick(kCloths), MutedColor(m)};
}

/// A coat that hangs from `hook` (its collar) in the plane x-y, as a slim body with sleeves.
void Coat(PieceMaker& m, const Vec& hook, float length) {
  const Surface cloth = Cloth(m);
  const Vec shoulders = hook - Vec(0, 0.14f, 0);
  m.TaperedBox(cloth, hook - Vec(0, length, 0), {0.38f, 0.12f}, shoulders, {0.36f, 0.11f});
  m.TaperedBox(cloth, shoulders, {0.36f, 0.11f}, hook, {0.1f, 0.06f});
  for (const float side : {-0.2f, 0.2f}) {
    m.TaperedBox(Shaded(cloth, 0.85f), shoulders + Vec(1.15f * side, -0.5f, 0.02f), {0.09f, 0.09f},
                 shoulders + Vec(0.85f * side, 0.03f, 0.02f), {0.1f, 0.09f});
  }
}

void Hat(PieceMaker& m, const Vec& at) {
  m.Turn({"wool_knit", MutedColor(m)}, at,
         {{0.0f, 0.0f}, {0.17f, 0.0f}, {0.1f, 0.02f}, {0.09f, 0.11f}, {0.0f, 0.12f}}, 10);
}

void CoatRack(PieceMaker& m) {
  const Surface surface = m.Chance(0.6) ? m.palette().wood : kBlackMetal;
  const float height = m.Draw(1.7f, 1.85f);
  m.Bar(surface, {0, 0.05f, 0}, {0, height, 0}, 0.027f, 6);
  for (int i = 0; i < 4; ++i) {
    const Frame frame(&m, {0, 0, 0}, kQuarterTurn * (static_cast<float>(i) + 0.5f));
    m.Bar(surface, {0, 0.2f, 0}, {0, 0.02f, 0.26f}, 0.02f, 4);
    m.Bar(surface, {0, height - 0.12f, 0}, {0, height + 0.02f, 0.17f}, 0.014f, 4);
    if (i % 2 == 0 || m.Chance(0.3)) Coat(m, {0, height - 0.05f, 0.18f}, m.Draw(0.75f, 1.05f));
  }
  Hat(m, {0, height - 0.01f, 0});
}

/// Garments on hangers along a rail on two feet.
void ClothesRail(PieceMaker& m) {
  const Surface& metal = m.palette().metal;
  const float half = 0.5f * m.Draw(0.9f, 1.25f);
  constexpr float kHigh = 1.55f;
  for (const float x : {-half, half}) {
    m.Bar(metal, {x, 0.04f, 0.23f}, {x, kHigh, 0.23f}, 0.018f, 5);
    m.Box(metal, {x - 0.02f, 0, 0}, {x + 0.02f, 0.04f, 0.46f});
  }
  m.Bar(metal, {-half, kHigh, 0.23f}, {half, kHigh, 0.23f}, 0.018f, 5);
  m.Box(metal, {-half, 0.12f, 0.08f}, {half, 0.14f, 0.38f});
  for (const float x : Spaced(-half + 0.1f, half - 0.25f, 0.085f)) {  // edge on
    const Surface cloth = Cloth(m);
    const float length = m.Draw(0.6f, 1.05f);
    m.TaperedBox(cloth, {x, kHigh - 0.1f - length, 0.23f}, {0.075f, 0.4f},
                 {x, kHigh - 0.12f, 0.23f}, {0.06f, 0.38f});
    m.TaperedBox(cloth, {x, kHigh - 0.12f, 0.23f}, {0.06f, 0.38f}, {x, kHigh - 0.02f, 0.23f},
                 {0.04f, 0.08f});
  }
  for (const float x : {-0.4f * half, 0.3f * half})
    m.Block(kCardboard, {x, 0.14f, 0.23f}, {0.3f, 0.13f, 0.2f});
}

/// A board with hooks, coats on some, a shelf above.
void CoatHooks(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.7f, 1.2f);
  constexpr float kHook = 1.0f;  // y = 0 is where the longest coat ends
  const Surface& wood = m.palette().wood;
  m.Box(wood, {-half, kHook - 0.02f, 0}, {half, kHook + 0.12f, 0.025f});
  m.Box(wood, {-half, kHook + 0.22f, 0}, {half, kHook + 0.25f, 0.25f});
  const float reach = half - 0.28f;  // coats are this broad
  const int hooks = std::max(2, 1 + static_cast<int>(std::lround(2.0f * reach / 0.22f)));
  for (int i = 0; i < hooks; ++i) {
    const float x = reach * (2.0f * static_cast<float>(i) / static_cast<float>(hooks - 1) - 1.0f);
    m.Box(m.palette().metal, {x - 0.012f, kHook + 0.02f, 0.025f},
          {x + 0.012f, kHook + 0.05f, 0.09f});
    if (i == 0) {
      Coat(m, {x, kHook + 0.04f, 0.1f}, 1.04f);
    } else if (m.Chance(0.55)) {
      const float out = m.Draw(0.09f, 0.12f);
      Coat(m, {x, kHook + 0.04f, out}, m.Draw(0.6f, 1.0f));
    }
  }
  if (half < 0.36f) return;
  Hat(m, {0.5f * half, kHook + 0.25f, 0.14f});
  m.Block(kWicker, {-0.45f * half, kHook + 0.25f, 0.13f}, {0.3f, 0.16f, 0.2f});
}

/// A pair of shoes pointing to the front.
void ShoePair(PieceMaker& m, const Vec& at, const Surface& surface) {
  for (const float x : {-0.06f, 0.06f}) {
    const Frame frame(&m, at + Vec(x, 0, 0));
    m.Box(kDark, {-0.046f, 0, -0.13f}, {0.046f, 0.022f, 0.15f});
    m.TaperedBox(surface, {0, 0.022f, 0.07f}, {0.09f, 0.15f}, {0, 0.065f, 0.04f}, {0.06f, 0.09f});
    m.TaperedBox(surface, {0, 0.022f, -0.06f}, {0.085f, 0.13f}, {0, 0.1f, -0.065f}, {0.07f, 0.11f});
    m.Quad(kDark, {-0.025f, 0.102f, -0.02f}, {0.025f, 0.102f, -0.02f}, {0.025f, 0.102f, -0.105f},
           {-0.025f, 0.102f, -0.105f});
  }
}

void ShoeCabinet(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.6f, 1.0f, 0.02f);
  if (m.Chance(0.5)) {  // flaps that tilt
    constexpr float kDepth = 0.22f;
    const float height = m.Draw(0.85f, 1.2f);
    const Surface& surface = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
    Body(m, surface, {-half, 0.03f, 0}, {half, height - 0.025f, kDepth});
    m.Box(kDark, {-half + 0.02f, 0, 0}, {half - 0.02f, 0.03f, kDepth - 0.03f});
    Drawers(m, surface, {-half, half, 0.03f, height - 0.025f, kDepth}, height > 1.0f ? 3 : 2);
    m.Box(m.palette().wood, {-half - 0.01f, height - 0.025f, 0},
          {half + 0.01f, height, kDepth + 0.02f});
    m.AddTop(height, {-half, 0.0f}, {half, kDepth});
    return;
  }
  constexpr float kDepth = 0.32f;
  constexpr float kHeight = 0.5f;
  const Surface& wood = m.palette().wood;
  for (const float x : {-half, half - 0.03f}) m.Box(wood, {x, 0, 0}, {x + 0.03f, kHeight, kDepth});
  for (const float y : {0.06f, 0.26f}) {
    m.Box(wood, {-half + 0.03f, y, 0}, {half - 0.03f, y + 0.025f, kDepth});
    for (const float x : Spaced(-half + 0.15f, half - 0.12f, 0.25f)) {
      if (m.Chance(0.85))
        ShoePair(m, {x, y + 0.025f, 0.17f},
                 {"leather", m.Chance(0.5) ? MutedColor(m) : Rgb8{70, 55, 45}});
    }
  }
  Cushion(m, m.palette().accent, {-half, kHeight - 0.03f, 0},
          {half, kHeight + 0.04f, kDepth + 0.01f}, 0.02f);
}

void UmbrellaStand(PieceMaker& m) {
  const Surface surface = m.Chance(0.5) ? m.palette().metal : Surface{"ceramic", MutedColor(m)};
  const float radius = m.Draw(0.11f, 0.14f);
  constexpr float kHeight = 0.5f;
  m.Turn(surface, {0, 0, 0},
         {{radius, 0.0f}, {radius, kHeight}, {0.88f * radius, kHeight}, {0.85f * radius, 0.3f}},
         10);
  m.Turn(kDark, {0, 0.3f, 0}, {{0.86f * radius, 0.0f}, {0.0f, 0.0f}}, 10);
  for (int i = 0; i < 3; ++i) {
    const float angle = 2.1f * static_cast<float>(i);
    const Frame frame(
        &m, Turned({0.3f * radius * Cos(angle), 0.05f, 0.3f * radius * Sin(angle)}, angle, 0.1f));
    m.TaperedBox({"canvas", i == 0 ? Rgb8{40, 40, 44} : BrightColor(m)}, {0, 0.1f, 0},
                 {0.03f, 0.03f}, {0, 0.66f, 0}, {0.075f, 0.075f});
    m.Cylinder(m.palette().wood, {0, 0.66f, 0}, 0.012f, 0.12f, 5);
    m.Box(m.palette().wood, {-0.012f, 0.77f, -0.012f}, {0.012f, 0.795f, 0.07f});
  }
}

void Slippers(PieceMaker& m) {
  const Surface cloth{"wool_knit", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
  for (const float x : {-0.065f, 0.065f}) {
    const float z = m.Draw(-0.03f, 0.03f);
    const Frame frame(&m, {x, 0, z}, m.Draw(-0.2f, 0.2f));
    m.Box(Shaded(cloth, 0.7f), {-0.047f, 0, -0.13f}, {0.047f, 0.02f, 0.13f});
    m.TaperedBox(cloth, {0, 0.02f, 0.05f}, {0.094f, 0.16f}, {0, 0.07f, 0.03f}, {0.06f, 0.09f});
  }
}

void Shoes(PieceMaker& m) {
  ShoePair(m, {0, 0, 0}, {"leather", m.Chance(0.5) ? MutedColor(m) : Rgb8{80, 60, 48}});
}

constexpr std::array kKinds = {
    FurnitureKind{"clothes_rail", Placement::kAgainstWall, 0.5f, ClothesRail},
    FurnitureKind{"coat_hooks", Placement::kOnWall, 0.4f, CoatHooks, 0.6f, 1.8f},
    FurnitureKind{"coat_rack", Placement::kFree, 0.2f, CoatRack},
    FurnitureKind{"shoe_cabinet", Placement::kAgainstWall, 0.5f, ShoeCabinet, 0.5f, 1.4f},
    FurnitureKind{"shoes", Placement::kFree, 0.0f, Shoes},
    FurnitureKind{"slippers", Placement::kFree, 0.0f, Slippers},
    FurnitureKind{"umbrella_stand", Placement::kFree, 0.1f, UmbrellaStand}};

}  // namespace

std::span<const FurnitureKind> Hall() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
