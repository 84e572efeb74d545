// SPDX-License-Identifier: MIT
// Machines and tools of workshops, beside those of industry.cpp.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

Surface MachinePaint(PieceMaker& m) {
  static constexpr std::array<Rgb8, 5> kColors = {Rgb8{96, 128, 112}, Rgb8{188, 194, 190},
                                                  Rgb8{64, 92, 132}, Rgb8{206, 160, 60},
                                                  Rgb8{110, 112, 116}};
  return {"painted_wood", m.rng().Pick(kColors)};
}

/// A bed on two feet, a headstock with its chuck, a tailstock, a carriage between them.
void Lathe(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.5f, 2.3f);
  const float deep = 0.5f * m.Draw(0.55f, 0.75f);
  const Surface body = MachinePaint(m);
  constexpr float kBed = 0.82f;
  for (const float x : {-half, 0.55f * half}) {
    m.Box(Shaded(body, 0.8f), {x, 0, -deep}, {x + 0.42f * half, kBed - 0.12f, deep});
  }
  m.Box(kSteel, {-half, kBed - 0.12f, -deep}, {half, kBed, deep});
  m.Box(body, {-half, kBed, -deep}, {-0.52f * half, kBed + m.Draw(0.42f, 0.55f), deep});
  m.Bar(kSteel, {-0.52f * half, kBed + 0.24f, 0}, {-0.52f * half + 0.12f, kBed + 0.24f, 0}, 0.13f,
        12);
  const float at = m.Draw(-0.2f, 0.3f) * half;
  m.Box(body, {at, kBed, -0.8f * deep}, {at + 0.28f, kBed + 0.14f, deep + 0.08f});
  m.Box(kSteel, {at + 0.08f, kBed + 0.14f, -0.1f}, {at + 0.2f, kBed + 0.24f, 0.1f});
  m.Box(body, {0.66f * half, kBed, -0.6f * deep}, {0.92f * half, kBed + 0.34f, 0.6f * deep});
  m.Bar(kChrome, {0.5f * half, kBed + 0.24f, 0}, {0.66f * half, kBed + 0.24f, 0}, 0.04f, 8);
  m.Box(Shaded(body, 0.9f), {-half, kBed, -deep - 0.04f}, {half, kBed + 0.5f, -deep});
}

/// A press: a heavy frame with a ram over a table.
void Press(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.9f, 1.4f);
  const float deep = 0.5f * m.Draw(0.7f, 1.0f);
  const float high = m.Draw(1.8f, 2.05f);
  const Surface body = MachinePaint(m);
  m.Box(Shaded(body, 0.8f), {-half, 0, -deep}, {half, 0.7f, deep});
  for (const float x : {-half, half - 0.2f}) {
    m.Box(body, {x, 0.7f, -deep}, {x + 0.2f, high - 0.35f, deep});
  }
  m.Box(body, {-half, high - 0.35f, -deep}, {half, high, deep});
  const float ram = m.Draw(1.0f, 1.2f);
  m.Box(kSteel, {-0.4f * half, ram, -0.5f * deep}, {0.4f * half, high - 0.35f, 0.5f * deep});
  m.Box(kSteel, {-0.7f * half, 0.7f, -0.8f * deep}, {0.7f * half, 0.78f, 0.8f * deep});
  m.Box({"plastic", {230, 190, 30}}, {-half, high - 0.36f, deep},
        {half, high - 0.3f, deep + 0.01f});
  m.Box(kBlackPlastic, {half, 0.95f, 0.2f * deep}, {half + 0.1f, 1.35f, 0.8f * deep});
}

/// A pillar with a drill head over a round or square table.
void DrillPress(PieceMaker& m) {
  const Surface body = MachinePaint(m);
  const float high = m.Draw(1.6f, 1.9f);
  m.Box(kBlackMetal, {-0.25f, 0, -0.32f}, {0.25f, 0.08f, 0.3f});
  m.Cylinder(kSteel, {0, 0.08f, -0.2f}, 0.05f, high - 0.35f, 8);
  m.Box(body, {-0.16f, high - 0.35f, -0.36f}, {0.16f, high, 0.3f});
  m.Cylinder(kSteel, {0, high - 0.6f, 0.16f}, 0.035f, 0.25f, 8);
  const float table = m.Draw(0.8f, 0.95f);
  m.Box(kSteel, {-0.2f, table, -0.16f}, {0.2f, table + 0.05f, 0.32f});
  m.Bar(kBlackMetal, {0.16f, high - 0.25f, 0.1f}, {0.36f, high - 0.4f, 0.22f}, 0.015f, 5);
}

/// A circular saw in a large table.
void TableSaw(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.2f, 2.0f);
  const float deep = 0.5f * m.Draw(0.8f, 1.3f);
  const Surface body = MachinePaint(m);
  m.Box(body, {-0.45f * half, 0, -0.7f * deep}, {0.55f * half, 0.8f, 0.7f * deep});
  m.Box(kSteel, {-half, 0.8f, -deep}, {half, 0.86f, deep});
  for (const float z : {-0.85f * deep, 0.85f * deep - 0.05f}) {
    Post(m, body, {-half + 0.08f, 0, z}, 0.05f, 0.8f);
  }
  m.Box(kChrome, {0.02f, 0.86f, -0.16f}, {0.03f, 0.96f, 0.16f});
  m.Box(kSteel, {0.35f * half, 0.86f, -0.9f * deep}, {0.35f * half + 0.05f, 0.93f, 0.9f * deep});
  const Surface plank{m.Chance(0.5) ? "pine" : "beech"};
  const float wide = m.Draw(0.1f, 0.24f);
  m.Box(plank, {-0.6f * half, 0.86f, -0.8f * deep}, {-0.6f * half + wide, 0.9f, 0.9f * deep});
}

/// A board with tools on it.
void ToolWall(PieceMaker& m) {
  const float width = m.Width(1.2f, 2.2f);
  const float half = 0.5f * width;
  const float high = m.Draw(0.8f, 1.2f);
  const Surface board = m.Chance(0.5) ? m.palette().wood : Surface{"painted_wood", MutedColor(m)};
  Panel(m, board, {-half, 0, 0}, {half, high, 0.025f});
  for (const float x : Spaced(-half + 0.06f, half - 0.12f, 0.17f)) {
    for (const float y : {0.06f * high, 0.54f * high}) {
      if (m.Chance(0.15)) continue;
      const Surface grip{"plastic", m.Chance(0.4) ? kWhite : BrightColor(m)};
      const Vec2 size = m.Draw(Vec2(0.03f, 0.5f), Vec2(0.1f, 0.85f));
      const float top = y + 0.44f * high;
      Panel(m, kSteel, {x, top - size.y() * 0.4f * high, 0.025f}, {x + size.x(), top, 0.045f});
      Panel(m, grip, {x + 0.2f * size.x(), y, 0.025f},
            {x + 0.8f * size.x(), top - size.y() * 0.4f * high, 0.055f});
    }
  }
}

/// A cabinet of drawers on wheels.
void ToolCart(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.6f, 0.8f);
  const float high = m.Draw(0.85f, 1.0f);
  const Surface paint{"painted_wood", m.Chance(0.6) ? BrightColor(m) : Rgb8{60, 62, 66}};
  for (const float x : {-half + 0.06f, half - 0.06f}) {
    for (const float z : {-0.17f, 0.17f}) m.Block(kRubber, {x, 0, z}, {0.05f, 0.12f, 0.1f});
  }
  m.Box(paint, {-half, 0.12f, -0.23f}, {half, high, 0.23f});
  const int drawers = m.Between(4, 6);
  const float pitch = (high - 0.18f) / static_cast<float>(drawers);
  for (int i = 0; i < drawers; ++i) {
    const float y = 0.15f + pitch * static_cast<float>(i);
    Panel(m, Shaded(paint, 0.85f), {-half + 0.02f, y, 0.23f},
          {half - 0.02f, y + pitch - 0.015f, 0.245f});
    Panel(m, kChrome, {-half + 0.06f, y + pitch - 0.05f, 0.245f},
          {half - 0.06f, y + pitch - 0.035f, 0.26f});
  }
  m.AddTop(high, {-half, -0.23f}, {half, 0.23f});
}

constexpr std::array kKinds = {
    FurnitureKind{"drill_press", Placement::kFree, 0.4f, DrillPress},
    FurnitureKind{"lathe", Placement::kFree, 0.5f, Lathe},
    FurnitureKind{"press", Placement::kFree, 0.5f, Press},
    FurnitureKind{"table_saw", Placement::kFree, 0.6f, TableSaw},
    FurnitureKind{"tool_cart", Placement::kFree, 0.3f, ToolCart},
    FurnitureKind{"tool_wall", Placement::kOnWall, 0.3f, ToolWall, 0.9f, 2.4f}};

}  // namespace

std::span<const FurnitureKind> Tools() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
