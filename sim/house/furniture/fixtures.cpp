// SPDX-License-Identifier: MIT
// What larger buildings are fitted with, whatever they are used for.
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr Surface kLit{"lamp_shade", {255, 252, 246}};

/// As high as asked for, or as usual.
float Height(PieceMaker& m, float low, float high) {
  const float drawn = m.Draw(low, high);
  return m.request().height > 0.0f ? m.request().height : drawn;
}

void Column(PieceMaker& m) {
  const float high = Height(m, 1.9f, 2.05f);
  const float side = m.Draw(0.3f, 0.6f);
  const Surface body = m.Chance(0.3)
                           ? Surface{"concrete"}
                           : Surface{"plaster_smooth", m.Chance(0.8) ? kWhite : MutedColor(m)};
  if (m.Chance(0.35)) {
    m.Cylinder(body, {0, 0, 0}, 0.5f * side, high, 14);
    return;
  }
  m.Block(body, {0, 0, 0}, {side, high, side});
  if (m.Chance(0.4)) {  // a guard around its foot
    const Surface guard{"painted_wood", BrightColor(m)};
    m.Block(guard, {0, 0, 0}, {side + 0.03f, m.Draw(0.1f, 1.1f), side + 0.03f});
  }
}

/// Panes in a frame from the floor up, seen from both sides.
void GlassScreen(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.4f);
  const float high = Height(m, 1.8f, 2.05f);
  const Surface& bars = m.palette().metal;
  const float foot = m.Chance(0.4) ? 0.85f : 0.06f;
  const auto panes = std::max(1, static_cast<int>(std::lround(2.0f * half / 1.0f)));
  m.Box(m.palette().cabinet, {-half, 0, -0.03f}, {half, foot, 0.03f});
  m.Box(kGlass, {-half, foot, -0.012f}, {half, high - 0.06f, 0.012f});
  m.Box(bars, {-half, high - 0.06f, -0.03f}, {half, high, 0.03f});
  for (int i = 0; i <= panes; ++i) {
    const float x =
        -half + 0.025f + (2.0f * half - 0.05f) * static_cast<float>(i) / static_cast<float>(panes);
    m.Box(bars, {x - 0.025f, foot, -0.03f}, {x + 0.025f, high - 0.06f, 0.03f});
  }
}

/// Cloth-covered screen between workplaces.
void Partition(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.2f);
  const float high = Height(m, 1.2f, 1.7f);
  const Surface cloth = m.Chance(0.5) ? m.palette().fabric : m.palette().accent;
  m.Box(cloth, {-half + 0.02f, 0.08f, -0.03f}, {half - 0.02f, high - 0.03f, 0.03f});
  m.Box(m.palette().metal, {-half, high - 0.03f, -0.035f}, {half, high, 0.035f});
  for (const float x : {-half + 0.015f, half - 0.015f}) {
    m.Box(m.palette().metal, {x - 0.015f, 0, -0.035f}, {x + 0.015f, high - 0.03f, 0.035f});
    m.Box(m.palette().metal, {x - 0.015f, 0, -0.16f}, {x + 0.015f, 0.03f, 0.16f});
  }
}

/// A counter people stand before (+z), with a lower desk behind it.
void ServiceCounter(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.6f, 2.5f, 0.06f);
  const float high = m.Draw(1.02f, 1.15f);
  constexpr float kFront = 0.36f;
  const Surface front = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
  m.Box(front, {-half, 0.08f, 0.2f}, {half, high - 0.04f, kFront});
  m.Box(kDark, {-half + 0.03f, 0, 0.2f}, {half - 0.03f, 0.08f, kFront - 0.06f});
  m.Box(m.palette().counter, {-half - 0.03f, high - 0.04f, 0.12f},
        {half + 0.03f, high, kFront + 0.05f});
  m.Box(m.palette().counter, {-half, 0.71f, -0.4f}, {half, 0.74f, 0.2f});
  for (const float x : {-half, half - 0.03f})
    m.Box(front, {x, 0, -0.38f}, {x + 0.03f, 0.71f, 0.2f});
  const auto screens = std::max(1, static_cast<int>(half / 0.9f));
  for (int i = 0; i < screens; ++i) {
    const float x =
        half * ((2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(screens) - 1.0f);
    m.Block(kBlackPlastic, {x, 0.74f, -0.02f}, {0.2f, 0.12f, 0.1f});
    m.Box(kBlackPlastic, {x - 0.25f, 0.86f, -0.03f}, {x + 0.25f, 1.18f, 0.01f});
  }
  m.AddTop(high, {-half, 0.13f}, {half, kFront + 0.04f});
}

/// Lockers with doors side by side in two rows.
void LockerRow(PieceMaker& m) {
  const float width = m.Width(1.2f, 2.4f);
  const float half = 0.5f * width;
  const float high = m.Draw(1.7f, 1.95f);
  const Surface steel{"painted_wood", m.Chance(0.5) ? MutedColor(m) : Rgb8{168, 172, 176}};
  const int columns = std::max(2, static_cast<int>(width / 0.35f));
  m.Box(kDark, {-half + 0.01f, 0, 0.01f}, {half - 0.01f, 0.08f, 0.44f});
  m.Box(Shaded(steel, 0.6f), {-half, 0.08f, 0}, {half, high, 0.46f});
  for (int i = 0; i < 2 * columns; ++i) {
    const int column = i / 2;
    const float x0 = -half + width * static_cast<float>(column) / static_cast<float>(columns);
    const float x1 = x0 + width / static_cast<float>(columns);
    const float middle = 0.5f * (0.08f + high);
    const float y0 = i % 2 == 0 ? 0.08f : middle;
    const float y1 = i % 2 == 0 ? middle : high;
    Panel(m, steel, {x0 + 0.006f, y0 + 0.008f, 0.46f}, {x1 - 0.006f, y1 - 0.008f, 0.475f});
    Panel(m, kChrome, {x1 - 0.06f, 0.5f * (y0 + y1), 0.475f},
          {x1 - 0.035f, 0.5f * (y0 + y1) + 0.1f, 0.49f});
  }
}

/// Cubicle of a public toilet, its door shut.
void ToiletStall(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.88f, 1.0f);
  const float deep = m.Draw(1.35f, 1.5f);
  const float high = m.Draw(1.9f, 2.05f);
  const Surface board{"plastic", m.Chance(0.5) ? MutedColor(m) : Rgb8{215, 218, 220}};
  m.Box(board, {-half, 0.15f, 0}, {half, high, deep});
  for (const float x : {-half + 0.03f, half - 0.03f})
    Post(m, kSteel, {x, 0, deep - 0.04f}, 0.04f, 0.15f);
  m.Box(kDark, {-half + 0.1f, 0, 0.05f}, {half - 0.1f, 0.15f, deep - 0.2f});
  Panel(m, Shaded(board, 0.86f), {-0.31f, 0.16f, deep}, {0.31f, high - 0.05f, deep + 0.012f});
  Panel(m, kChrome, {0.2f, 1.0f, deep + 0.012f}, {0.27f, 1.07f, deep + 0.03f});
}

void VendingMachine(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.75f, 1.0f);
  const float high = m.Draw(1.75f, 1.95f);
  const Surface body{"plastic", BrightColor(m)};
  m.Box(body, {-half, 0.06f, 0}, {half, high, 0.78f});
  m.Box(kDark, {-half + 0.04f, 0, 0.04f}, {half - 0.04f, 0.06f, 0.7f});
  const float x = half - 0.26f;
  Panel(m, kBlackPlastic, {-half + 0.04f, 0.5f, 0.78f}, {x, high - 0.12f, 0.79f});
  const Surface goods{m.Chance(0.5) ? "bottles" : "food_boxes"};
  m.Picture(goods, {-half + 0.06f, 0.52f, 0.795f}, {x - 0.02f, 0.52f, 0.795f},
            {x - 0.02f, high - 0.14f, 0.795f}, {-half + 0.06f, high - 0.14f, 0.795f});
  Panel(m, kBlackPlastic, {x + 0.06f, 1.1f, 0.78f}, {half - 0.05f, 1.4f, 0.79f});
  Panel(m, kDark, {-half + 0.1f, 0.15f, 0.78f}, {half - 0.1f, 0.34f, 0.788f});
}

void WaterCooler(PieceMaker& m) {
  const Surface body = m.Chance(0.6) ? kWhitePlastic : kGreyPlastic;
  const float high = m.Draw(0.95f, 1.05f);
  m.Block(body, {0, 0, 0}, {0.31f, high, 0.32f});
  m.Cylinder({"plastic", {150, 190, 220}}, {0, high, 0}, 0.13f, 0.36f, 10);
  m.Box(kDark, {-0.1f, high - 0.3f, 0.16f}, {0.1f, high - 0.12f, 0.168f});
}

void FireExtinguisher(PieceMaker& m) {
  const Surface red{"plastic", {200, 32, 28}};
  const float radius = m.Draw(0.07f, 0.09f);
  m.Box(kBlackMetal, {-0.03f, 0.1f, 0}, {0.03f, 0.5f, 0.02f});
  m.Cylinder(red, {0, 0, 0.02f + radius}, radius, 0.46f, 8);
  m.Cone(kBlackMetal, {0, 0.46f, 0.02f + radius}, radius, 0.03f, 0.08f, 8);
}

void ExitSign(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.32f, 0.42f);
  Panel(m, {"plastic", {28, 140, 78}}, {-half, 0, 0}, {half, half, 0.04f});
  Panel(m, kWhitePlastic, {-0.7f * half, 0.35f * half, 0.04f}, {0.3f * half, 0.62f * half, 0.045f});
  m.Triangle(kWhitePlastic, {0.3f * half, 0.2f * half, 0.044f},
             {0.75f * half, 0.48f * half, 0.044f}, {0.3f * half, 0.78f * half, 0.044f});
}

/// A lit panel flush with the ceiling.
void PanelLamp(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.58f, 0.62f);
  const float deep = m.Chance(0.5) ? half : 0.5f * half;
  m.Box(kWhitePaint, {-half, -0.06f, -deep}, {half, 0, deep});
  m.SetGlow(Glow::kLamp);
  m.Quad(kLit, {-half + 0.02f, -0.062f, -deep + 0.02f}, {half - 0.02f, -0.062f, -deep + 0.02f},
         {half - 0.02f, -0.062f, deep - 0.02f}, {-half + 0.02f, -0.062f, deep - 0.02f});
  m.SetGlow(Glow::kNone);
}

/// Fluorescent tubes under a reflector.
void TubeLamp(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.1f, 1.25f);
  const float drop = m.Chance(0.5) ? 0.0f : m.Draw(0.2f, 0.5f);
  if (drop > 0.0f) {
    for (const float x : {-0.6f * half, 0.6f * half})
      m.Bar(kSteel, {x, -drop, 0}, {x, 0, 0}, 0.01f, 4);
  }
  m.Box(kWhitePaint, {-half, -drop - 0.05f, -0.07f}, {half, -drop, 0.07f});
  m.SetGlow(Glow::kLamp);
  const float y = -drop - 0.055f;
  m.Quad(kLit, {-half + 0.03f, y, -0.05f}, {half - 0.03f, y, -0.05f}, {half - 0.03f, y, 0.05f},
         {-half + 0.03f, y, 0.05f});
  m.SetGlow(Glow::kNone);
}

/// A bell over high halls.
void BayLamp(PieceMaker& m) {
  const float drop = m.Draw(0.3f, 0.7f);
  const float radius = m.Draw(0.2f, 0.3f);
  m.Bar(kBlackMetal, {0, -drop, 0}, {0, 0, 0}, 0.012f, 4);
  m.Turn(kSteel, {0, -drop - 0.25f, 0},
         {{radius, 0.0f}, {0.7f * radius, 0.14f}, {0.25f * radius, 0.25f}, {0.0f, 0.26f}}, 10);
  m.SetGlow(Glow::kLamp);
  m.Turn(kLit, {0, -drop - 0.24f, 0}, {{0.0f, 0.0f}, {0.95f * radius, 0.0f}}, 10);
  m.SetGlow(Glow::kNone);
}

constexpr std::array kKinds = {
    FurnitureKind{"bay_lamp", Placement::kCeiling, 0.0f, BayLamp},
    FurnitureKind{"column", Placement::kFree, 0.0f, Column},
    FurnitureKind{"exit_sign", Placement::kOnWall, 0.0f, ExitSign},
    FurnitureKind{"fire_extinguisher", Placement::kOnWall, 0.0f, FireExtinguisher},
    FurnitureKind{"glass_screen", Placement::kFree, 0.0f, GlassScreen, 0.8f, 4.0f},
    FurnitureKind{"locker_row", Placement::kAgainstWall, 0.7f, LockerRow, 0.8f, 3.6f},
    FurnitureKind{"panel_lamp", Placement::kCeiling, 0.0f, PanelLamp},
    FurnitureKind{"partition", Placement::kFree, 0.0f, Partition, 0.8f, 2.4f},
    FurnitureKind{"service_counter", Placement::kFree, 0.5f, ServiceCounter, 1.2f, 6.0f},
    FurnitureKind{"toilet_stall", Placement::kAgainstWall, 0.6f, ToiletStall},
    FurnitureKind{"tube_lamp", Placement::kCeiling, 0.0f, TubeLamp},
    FurnitureKind{"vending_machine", Placement::kAgainstWall, 0.6f, VendingMachine},
    FurnitureKind{"water_cooler", Placement::kFree, 0.2f, WaterCooler}};

}  // namespace

std::span<const FurnitureKind> Fixtures() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
