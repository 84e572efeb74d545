// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// Seat of a chair centred on x = 0; the backrest stands at z = 0, the sitter looks to +z.
struct ChairShape {
  float width = 0.45f;
  float depth = 0.46f;
  float seat = 0.46f;
  float back = 0.9f;
};

void SlatBack(PieceMaker& m, const Surface& wood, const ChairShape& c) {
  const float x = 0.5f * c.width - 0.02f;
  const Frame frame(&m, Turned({0, c.seat, 0.04f}, 0.0f, -0.12f));
  const float height = c.back - c.seat;
  for (const float side : {-x, x}) Post(m, wood, {side, -0.02f, 0}, 0.04f, height + 0.02f);
  const int slats = m.Between(2, 3);
  for (int i = 0; i < slats; ++i) {
    const float y = height - 0.1f - 0.14f * static_cast<float>(i);
    m.Box(wood, {-x, y, -0.01f}, {x, y + 0.08f, 0.015f});
  }
}

void SpindleBack(PieceMaker& m, const Surface& wood, const ChairShape& c) {
  const float x = 0.5f * c.width - 0.02f;
  const Frame frame(&m, Turned({0, c.seat, 0.04f}, 0.0f, -0.15f));
  const float height = c.back - c.seat;
  for (int i = 0; i < 6; ++i) {
    const float at = x * (0.4f * static_cast<float>(i) - 1.0f);
    const bool is_outer = i == 0 || i == 5;
    Post(m, wood, {at, -0.02f, 0}, is_outer ? 0.035f : 0.02f, height - 0.04f);
  }
  m.Box(wood, {-x - 0.03f, height - 0.08f, -0.02f}, {x + 0.03f, height, 0.02f});
}

void WoodenChair(PieceMaker& m, const ChairShape& c, bool has_spindles) {
  const Surface wood = m.Chance(0.25) ? m.palette().cabinet : m.palette().wood;
  const Vec2 half(0.5f * c.width, 0);
  Legs(m, wood,
       {m.Chance(0.5) ? LegStyle::kTapered : LegStyle::kSquare, -half, half + Vec2(0, c.depth),
        c.seat - 0.03f, 0.042f});
  m.Box(wood, {-half.x(), c.seat - 0.05f, 0}, {half.x(), c.seat - 0.01f, c.depth});
  if (m.Chance(0.5)) {
    Cushion(m, m.palette().accent, {-half.x() + 0.02f, c.seat - 0.01f, 0.04f},
            {half.x() - 0.02f, c.seat + 0.03f, c.depth - 0.01f}, 0.02f);
  }
  if (has_spindles) {
    SpindleBack(m, wood, c);
  } else {
    SlatBack(m, wood, c);
  }
}

void PaddedChair(PieceMaker& m, const ChairShape& c) {
  const Surface& cloth = m.palette().fabric;
  const float half = 0.5f * c.width;
  Legs(m, m.palette().other_wood,
       {LegStyle::kTapered, {-half, 0.02f}, {half, c.depth}, c.seat - 0.08f, 0.042f});
  Cushion(m, cloth, {-half, c.seat - 0.09f, 0.02f}, {half, c.seat, c.depth + 0.01f}, 0.025f);
  const Frame frame(&m, Turned({0, c.seat - 0.08f, 0.02f}, 0.0f, -0.12f));
  m.RoundedBox(cloth, {-half, 0, 0}, {half, c.back - c.seat + 0.1f, 0.07f}, 0.03f);
}

/// Moulded shell on splayed legs.
void ShellChair(PieceMaker& m, const ChairShape& c) {
  const Surface shell{"plastic", m.Chance(0.5) ? Rgb8{240, 240, 236} : MutedColor(m)};
  const float half = 0.5f * c.width;
  Legs(m, m.palette().wood,
       {LegStyle::kSplayed, {-half, 0.0f}, {half, c.depth}, c.seat - 0.03f, 0.032f});
  m.TaperedBox(shell, {0, c.seat - 0.04f, 0.5f * c.depth}, {0.7f * c.width, 0.75f * c.depth},
               {0, c.seat, 0.5f * c.depth}, {c.width, c.depth});
  const Frame frame(&m, Turned({0, c.seat - 0.01f, 0.03f}, 0.0f, -0.2f));
  m.TaperedBox(shell, {0, 0, 0}, {c.width, 0.03f}, {0, 0.2f, -0.01f}, {c.width + 0.02f, 0.03f});
  m.TaperedBox(shell, {0, 0.2f, -0.01f}, {c.width + 0.02f, 0.03f}, {0, 0.38f, -0.01f},
               {0.55f * c.width, 0.03f});
}

void DiningChair(PieceMaker& m) {
  ChairShape c;
  c.width = m.Draw(0.42f, 0.48f);
  c.depth = m.Draw(0.42f, 0.47f);
  c.back = m.Draw(0.84f, 1.0f);
  switch (m.Below(4)) {
    case 0:
      return WoodenChair(m, c, false);
    case 1:
      return WoodenChair(m, c, true);
    case 2:
      return PaddedChair(m, c);
    case 3:
      return ShellChair(m, c);
  }
}

void BarStool(PieceMaker& m) {
  const float seat = m.Draw(0.66f, 0.76f);
  const Surface cover = m.Chance(0.5) ? m.palette().wood : m.palette().fabric;
  const float radius = m.Draw(0.16f, 0.19f);
  if (m.Chance(0.35)) {  // chrome column
    m.Turn(kChrome, {0, 0, 0},
           {{0.2f, 0.0f}, {0.19f, 0.02f}, {0.03f, 0.04f}, {0.03f, seat - 0.06f}}, 10);
    m.Turn(kChrome, {0, 0.25f, 0}, {{0.14f, 0.0f}, {0.14f, 0.02f}, {0.12f, 0.02f}, {0.12f, 0.0f}},
           8);
  } else {
    const Vec2 half(0.21f, 0.21f);
    const Surface& legs = m.Chance(0.5) ? m.palette().metal : m.palette().wood;
    Legs(m, legs, {LegStyle::kSplayed, -half, half, seat - 0.04f, 0.035f});
    for (const float side : {-0.17f, 0.17f}) {
      m.Box(legs, {-0.17f, 0.22f, side - 0.012f}, {0.17f, 0.245f, side + 0.012f});
      m.Box(legs, {side - 0.012f, 0.22f, -0.17f}, {side + 0.012f, 0.245f, 0.17f});
    }
  }
  m.Turn(cover, {0, seat - 0.06f, 0},
         {{0.0f, 0.0f}, {radius, 0.01f}, {radius, 0.05f}, {0.9f * radius, 0.06f}, {0.0f, 0.06f}},
         12);
  if (m.Chance(0.4)) {
    const Frame frame(&m, Turned({0, seat - 0.02f, -radius + 0.02f}, 0.0f, -0.12f));
    for (const float x : {-0.1f, 0.1f}) Post(m, m.palette().metal, {x, 0, 0}, 0.022f, 0.26f);
    m.Box(cover, {-0.16f, 0.15f, -0.015f}, {0.16f, 0.29f, 0.02f});
  }
}

void Bench(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.95f, 1.4f);
  const float depth = m.Draw(0.36f, 0.42f);
  const float height = m.Draw(0.43f, 0.48f);
  const Surface& wood = m.palette().wood;
  Legs(m, wood,
       {DrawLegStyle(m),
        {-half + 0.04f, 0.02f},
        {half - 0.04f, depth - 0.02f},
        height - 0.08f,
        0.06f});
  if (m.Chance(0.5)) {
    m.Box(wood, {-half, height - 0.1f, 0}, {half, height - 0.06f, depth});
    Cushion(m, m.palette().accent, {-half, height - 0.06f, 0}, {half, height + 0.02f, depth},
            0.03f);
  } else {
    for (int i = 0; i < 3; ++i) {
      const float z = depth * static_cast<float>(i) / 3.0f;
      m.Box(wood, {-half, height - 0.08f, z + 0.01f},
            {half, height - 0.04f, z + depth / 3.0f - 0.01f});
    }
    m.AddTop(height - 0.04f, {-half, 0.0f}, {half, depth});
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"bar_stool", Placement::kFree, 0.2f, BarStool},
    FurnitureKind{"bench", Placement::kAgainstWall, 0.5f, Bench, 0.8f, 1.8f},
    FurnitureKind{"dining_chair", Placement::kFree, 0.2f, DiningChair}};

}  // namespace

std::span<const FurnitureKind> Chairs() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
