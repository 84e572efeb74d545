// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// Rectangular top on four legs with a rail under it, centred on x = 0 between z = 0 and depth.
struct TableShape {
  float width = 1.6f;
  float depth = 0.9f;
  float height = 0.74f;
  float top = 0.04f;  // thickness
  float leg = 0.07f;
};

void TableTop(PieceMaker& m, const Surface& surface, const TableShape& t) {
  m.Box(surface, {-0.5f * t.width, t.height - t.top, 0}, {0.5f * t.width, t.height, t.depth});
  m.AddTop(t.height, {-0.5f * t.width, 0.0f}, {0.5f * t.width, t.depth});
}

void FourLegs(PieceMaker& m, const Surface& surface, const TableShape& t) {
  const Vec2 half(0.5f * t.width - 0.03f, 0.5f * t.depth - 0.03f);
  const Vec2 middle(0, 0.5f * t.depth);
  const float under = t.height - t.top;
  Legs(m, surface, {DrawLegStyle(m), middle - half, middle + half, under, t.leg});
  if (m.Chance(0.6)) {
    m.Box(surface, {-half.x() + 0.08f, under - 0.08f, 0.09f},
          {half.x() - 0.08f, under, t.depth - 0.09f});
  }
}

/// Two broad feet joined by a beam.
void Trestle(PieceMaker& m, const Surface& surface, const TableShape& t) {
  const float x = 0.5f * t.width - 0.25f;
  const float under = t.height - t.top;
  const float middle = 0.5f * t.depth;
  for (const float side : {-x, x}) {
    m.Box(surface, {side - 0.04f, 0, 0.1f}, {side + 0.04f, 0.06f, t.depth - 0.1f});
    m.Box(surface, {side - 0.035f, 0.06f, middle - 0.1f}, {side + 0.035f, under, middle + 0.1f});
    m.Box(surface, {side - 0.04f, under - 0.06f, 0.06f}, {side + 0.04f, under, t.depth - 0.06f});
  }
  m.Box(surface, {-x, 0.3f, middle - 0.025f}, {x, 0.38f, middle + 0.025f});
}

void Pedestal(PieceMaker& m, const Surface& surface, const Vec& foot, float under) {
  m.Turn(surface, foot,
         {{0.3f, 0.0f}, {0.28f, 0.03f}, {0.06f, 0.08f}, {0.05f, 0.5f * under}, {0.08f, under}}, 10);
}

void RoundTop(PieceMaker& m, const Surface& surface, float radius, float height, float thickness) {
  m.Cylinder(surface, {0, height - thickness, 0}, radius, thickness, 20);
  const float side = 0.68f * radius;
  m.AddTop(height, {-side, -side}, {side, side});
}

void DiningTable(PieceMaker& m) {
  TableShape t;
  t.width = m.Width(1.4f, 2.1f, 0.02f);
  t.depth = m.Draw(0.82f, 0.98f);
  t.height = m.Draw(0.72f, 0.76f);
  t.leg = m.Draw(0.06f, 0.09f);
  const Surface& wood = m.palette().wood;
  const bool is_painted = m.Chance(0.25);
  const Surface& below = is_painted ? m.palette().cabinet : wood;
  if (m.Chance(0.3)) {
    Trestle(m, below, t);
  } else {
    FourLegs(m, below, t);
  }
  TableTop(m, wood, t);
  if (m.Chance(0.3)) {  // a runner along the middle, hanging over both ends
    const float x = 0.5f * t.width + 0.008f;
    const float z = 0.5f * t.depth;
    const Surface& cloth = m.palette().accent;
    m.Box(cloth, {-x, t.height, z - 0.17f}, {x, t.height + 0.006f, z + 0.17f});
    for (const float side : {-x, x - 0.006f}) {
      m.Box(cloth, {side, t.height - 0.2f, z - 0.17f}, {side + 0.006f, t.height, z + 0.17f});
    }
  }
}

void RoundDiningTable(PieceMaker& m) {
  const float radius = m.Draw(0.48f, 0.66f);
  const float height = m.Draw(0.72f, 0.76f);
  const Surface& wood = m.palette().wood;
  if (m.Chance(0.5)) {
    Pedestal(m, m.Chance(0.5) ? wood : m.palette().metal, {0, 0, 0}, height - 0.03f);
  } else {
    const float side = 0.7f * radius;
    Legs(m, m.palette().other_wood,
         {LegStyle::kSplayed, {-side, -side}, {side, side}, height - 0.03f, 0.06f});
  }
  RoundTop(m, wood, radius, height, 0.035f);
}

void CoffeeTable(PieceMaker& m) {
  TableShape t;
  t.width = m.Draw(0.9f, 1.25f);
  t.depth = m.Draw(0.5f, 0.68f);
  t.height = m.Draw(0.36f, 0.46f);
  t.leg = m.Draw(0.05f, 0.08f);
  const Surface& wood = m.palette().wood;
  switch (m.Below(4)) {
    case 0:  // glass on metal, with a shelf
      FourLegs(m, m.palette().metal, t);
      TableTop(m, kGlass, t);
      break;
    case 1: {  // round
      const float radius = m.Draw(0.38f, 0.5f);
      RoundTop(m, wood, radius, t.height, 0.04f);
      const float side = 0.72f * radius;
      Legs(m, m.palette().metal,
           {LegStyle::kSplayed, {-side, -side}, {side, side}, t.height - 0.04f, 0.045f});
      break;
    }
    case 2:  // a solid block with open ends
      m.Box(wood, {-0.5f * t.width, 0.0f, 0.03f},
            {-0.5f * t.width + 0.05f, t.height - t.top, t.depth - 0.03f});
      m.Box(wood, {0.5f * t.width - 0.05f, 0.0f, 0.03f},
            {0.5f * t.width, t.height - t.top, t.depth - 0.03f});
      m.Box(m.palette().other_wood, {-0.5f * t.width, 0.1f, 0.05f},
            {0.5f * t.width, 0.14f, t.depth - 0.05f});
      TableTop(m, wood, t);
      break;
    case 3:
      FourLegs(m, wood, t);
      m.Box(m.palette().other_wood, {-0.5f * t.width + 0.06f, 0.12f, 0.06f},
            {0.5f * t.width - 0.06f, 0.14f, t.depth - 0.06f});
      TableTop(m, wood, t);
      Books(m, {-0.3f, 0.14f, 0.15f}, {0.05f, 0.24f, 0.4f});
      break;
  }
}

void SideTable(PieceMaker& m) {
  const float radius = m.Draw(0.2f, 0.27f);
  const float height = m.Draw(0.5f, 0.62f);
  const Surface& wood = m.palette().wood;
  if (m.Chance(0.5)) {
    m.Turn(m.Chance(0.5) ? m.palette().metal : wood, {0, 0, 0},
           {{0.7f * radius, 0.0f}, {0.7f * radius, 0.02f}, {0.03f, 0.05f}, {0.03f, height - 0.03f}},
           8);
    m.Cylinder(wood, {0, height - 0.03f, 0}, radius, 0.03f, 14);
  } else {
    const Vec2 half(radius, radius);
    Legs(m, wood, {LegStyle::kTapered, -half, half, height - 0.03f, 0.04f});
    m.Block(wood, {0, height - 0.03f, 0}, {2.1f * radius, 0.03f, 2.1f * radius});
    m.Block(m.palette().other_wood, {0, 0.18f, 0}, {1.8f * radius, 0.02f, 1.8f * radius});
  }
  m.AddTop(height, {-0.7f * radius, -0.7f * radius}, {0.7f * radius, 0.7f * radius});
}

void ConsoleTable(PieceMaker& m) {
  TableShape t;
  t.width = m.Width(0.8f, 1.3f);
  t.depth = m.Draw(0.28f, 0.38f);
  t.height = m.Draw(0.76f, 0.86f);
  t.leg = 0.045f;
  const Surface& wood = m.palette().wood;
  const float half = 0.5f * t.width - 0.03f;
  Legs(m, m.Chance(0.4) ? m.palette().metal : wood,
       {m.Chance(0.5) ? LegStyle::kSquare : LegStyle::kTapered,
        {-half, 0.03f},
        {half, t.depth - 0.03f},
        t.height - t.top,
        t.leg});
  TableTop(m, wood, t);
  if (m.Chance(0.6)) {
    const float y = t.height - t.top;
    Body(m, wood, {-half + 0.02f, y - 0.14f, 0.03f}, {half - 0.02f, y, t.depth - 0.04f});
    Drawers(m, wood, {-half + 0.02f, 0, y - 0.14f, y, t.depth - 0.04f}, 1);
    Drawers(m, wood, {0, half - 0.02f, y - 0.14f, y, t.depth - 0.04f}, 1);
  }
  if (m.Chance(0.5)) {
    m.Box(wood, {-half, 0.16f, 0.05f}, {half, 0.19f, t.depth - 0.05f});
    m.AddTop(0.19f, {-half, 0.05f}, {half, t.depth - 0.05f});
  }
}

/// High table to stand or perch at.
void BarTable(PieceMaker& m) {
  const float height = m.Draw(1.02f, 1.08f);
  if (m.Chance(0.5)) {
    Pedestal(m, m.palette().metal, {0, 0, 0}, height - 0.03f);
    RoundTop(m, m.palette().wood, m.Draw(0.32f, 0.4f), height, 0.03f);
    return;
  }
  TableShape t;
  t.width = m.Draw(1.0f, 1.4f);
  t.depth = m.Draw(0.5f, 0.65f);
  t.height = height;
  t.leg = 0.06f;
  FourLegs(m, m.palette().other_wood, t);
  m.Box(m.palette().other_wood, {-0.5f * t.width + 0.06f, 0.2f, 0.5f * t.depth - 0.02f},
        {0.5f * t.width - 0.06f, 0.24f, 0.5f * t.depth + 0.02f});
  TableTop(m, m.palette().wood, t);
}

constexpr std::array kKinds = {
    FurnitureKind{"bar_table", Placement::kFree, 0.6f, BarTable},
    FurnitureKind{"coffee_table", Placement::kFree, 0.4f, CoffeeTable},
    FurnitureKind{"console_table", Placement::kAgainstWall, 0.6f, ConsoleTable, 0.6f, 1.6f},
    FurnitureKind{"dining_table", Placement::kFree, 0.8f, DiningTable, 1.0f, 2.6f},
    FurnitureKind{"round_dining_table", Placement::kFree, 0.8f, RoundDiningTable},
    FurnitureKind{"side_table", Placement::kFree, 0.3f, SideTable}};

}  // namespace

std::span<const FurnitureKind> Tables() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
