// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// A lit shade: a cone frustum of given size, closed so that it looks full from all sides.
void Shade(PieceMaker& m, const Vec& bottom, float radius, float height, bool is_drum) {
  m.SetGlow(Glow::kLamp);
  m.Cone(m.palette().shade, bottom, radius, is_drum ? 0.92f * radius : 0.55f * radius, height, 12);
  m.SetGlow(Glow::kNone);
}

void Tripod(PieceMaker& m, float height) {
  constexpr float kThick = 0.019f;
  for (int i = 0; i < 3; ++i) {
    const float angle = 4.0f / 3.0f * kQuarterTurn * static_cast<float>(i);
    const Vec out(Sin(angle), 0, Cos(angle));
    m.Bar(m.palette().wood, 0.27f * out + Vec(0, kThick, 0),
          0.03f * out + Vec(0, height - 0.28f, 0), kThick, 5);
  }
}

/// A bow over the sitter, with a dome at its end.
void ArcLamp(PieceMaker& m, const Surface& metal) {
  m.Cylinder(metal, {-0.5f, 0, 0}, 0.16f, 0.05f, 10);
  Vec last(-0.5f, 0.05f, 0);
  for (int i = 1; i <= 6; ++i) {
    const float angle = 0.3f * static_cast<float>(i);
    const Vec next(-0.5f + 0.81f * (1.0f - Cos(angle)),
                   0.05f + 1.75f * Sin(std::min(angle, kQuarterTurn)), 0);
    m.Bar(metal, last, next, 0.019f, 5);
    last = next;
  }
  const Vec dome = last - Vec(0, 0.2f, 0);
  m.Turn(metal, dome, {{0.17f, 0.0f}, {0.13f, 0.12f}, {0.03f, 0.2f}}, 10);
  m.SetGlow(Glow::kLamp);
  m.Turn(m.palette().shade, dome, {{0.0f, 0.0f}, {0.168f, 0.002f}}, 10);
  m.SetGlow(Glow::kNone);
}

void FloorLamp(PieceMaker& m) {
  const Surface& metal = m.palette().metal;
  const float height = m.Draw(1.45f, 1.7f);
  const float radius = m.Draw(0.18f, 0.25f);
  const bool is_drum = m.Chance(0.5);
  switch (m.Below(3)) {
    case 0:  // a straight pole
      m.Turn(metal, {0, 0, 0}, {{0.15f, 0.0f}, {0.14f, 0.03f}, {0.0f, 0.04f}}, 10);
      m.Bar(metal, {0, 0.03f, 0}, {0, height - 0.1f, 0}, 0.019f, 5);
      return Shade(m, {0, height - 0.28f, 0}, radius, 0.28f, is_drum);
    case 1:
      Tripod(m, height);
      return Shade(m, {0, height - 0.3f, 0}, radius, 0.3f, true);
    case 2:
      return ArcLamp(m, metal);
  }
}

void TableLamp(PieceMaker& m) {
  const float radius = m.Draw(0.11f, 0.16f);
  const float foot = m.Draw(0.18f, 0.28f);
  switch (m.Below(3)) {
    case 0:
      m.Turn({"ceramic", MutedColor(m)}, {0, 0, 0},
             {{0.05f, 0.0f}, {0.085f, 0.35f * foot}, {0.03f, 0.8f * foot}, {0.015f, foot}}, 8);
      break;
    case 1:
      m.Cylinder(m.palette().metal, {0, 0, 0}, 0.07f, 0.02f, 8);
      m.Cylinder(m.palette().metal, {0, 0.02f, 0}, 0.014f, foot, 5);
      break;
    case 2:
      m.Ball({"ceramic", MutedColor(m)}, {0, 0.09f, 0}, {0.09f, 0.09f, 0.09f}, 8);
      m.Cylinder(m.palette().metal, {0, 0.17f, 0}, 0.012f, foot - 0.15f, 5);
      break;
  }
  const float height = m.Draw(0.16f, 0.22f);
  Shade(m, {0, foot, 0}, radius, height, m.Chance(0.4));
}

void WallLamp(PieceMaker& m) {
  const Surface& metal = m.palette().metal;
  if (m.Chance(0.5)) {  // light up and down
    m.Box(metal, {-0.04f, 0.08f, 0}, {0.04f, 0.2f, 0.05f});
    m.SetGlow(Glow::kLamp);
    m.Cylinder(m.palette().shade, {0, 0, 0.11f}, 0.065f, 0.28f, 10);
    m.SetGlow(Glow::kNone);
    return;
  }
  m.Box(metal, {-0.05f, 0, 0}, {0.05f, 0.16f, 0.025f});
  m.Bar(metal, {0, 0.06f, 0.02f}, {0, 0.09f, 0.14f}, 0.012f, 4);
  m.Bar(metal, {0, 0.09f, 0.14f}, {0, 0.15f, 0.14f}, 0.012f, 4);
  Shade(m, {0, 0.14f, 0.14f}, 0.11f, 0.16f, false);
}

void DeskLamp(PieceMaker& m) {
  const Surface color{"painted_wood", BrightColor(m)};
  m.Cylinder(color, {0, 0, -0.05f}, 0.085f, 0.025f, 10);
  const Vec elbow(0, 0.25f, -0.13f);
  const Vec head(0, 0.42f, 0.05f);
  m.Bar(m.palette().metal, {0, 0.02f, -0.05f}, elbow, 0.012f, 4);
  m.Bar(m.palette().metal, elbow, head, 0.012f, 4);
  const Frame frame(&m, Turned(head, 0.0f, 0.5f));
  m.Turn(color, {0, -0.11f, 0.04f}, {{0.09f, 0.0f}, {0.035f, 0.1f}, {0.03f, 0.14f}, {0.0f, 0.14f}},
         8);
  m.SetGlow(Glow::kLamp);
  m.Turn(m.palette().shade, {0, -0.108f, 0.04f}, {{0.0f, 0.0f}, {0.087f, 0.0f}}, 8);
  m.SetGlow(Glow::kNone);
}

constexpr std::array kKinds = {FurnitureKind{"desk_lamp", Placement::kOnTop, 0.0f, DeskLamp},
                               FurnitureKind{"floor_lamp", Placement::kFree, 0.1f, FloorLamp},
                               FurnitureKind{"table_lamp", Placement::kOnTop, 0.0f, TableLamp},
                               FurnitureKind{"wall_lamp", Placement::kOnWall, 0.0f, WallLamp}};

}  // namespace

std::span<const FurnitureKind> Lamps() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
