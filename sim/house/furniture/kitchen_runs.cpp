// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/kitchen_parts.h"

namespace bulletnav::sim::furniture {

void BaseBody(PieceMaker& m, const Along& along) {
  const Surface& cabinet = m.palette().cabinet;
  m.Box(Shaded(cabinet, 0.4f), {along.x0, 0, 0}, {along.x1, kKick, kUnitDepth - 0.06f});
  // No top: the worktop covers it, and a sink reaches down into it.
  const float top = kWorktop - kWorktopThick;
  m.Quad(Shaded(cabinet, 0.35f), {along.x0, kKick, kUnitDepth}, {along.x1, kKick, kUnitDepth},
         {along.x1, top, kUnitDepth}, {along.x0, top, kUnitDepth});
  m.Quad(cabinet, {along.x1, kKick, kUnitDepth}, {along.x1, kKick, 0}, {along.x1, top, 0},
         {along.x1, top, kUnitDepth});
  m.Quad(cabinet, {along.x0, kKick, 0}, {along.x0, kKick, kUnitDepth}, {along.x0, top, kUnitDepth},
         {along.x0, top, 0});
}

void BaseUnits(PieceMaker& m, const Along& along) {
  const Surface& cabinet = m.palette().cabinet;
  BaseBody(m, along);
  const int units = std::max(1, static_cast<int>(std::lround(along.width() / 0.58f)));
  const float width = along.width() / static_cast<float>(units);
  constexpr float kTop = kWorktop - kWorktopThick - 0.01f;
  for (int i = 0; i < units; ++i) {
    const float x0 = along.x0 + width * static_cast<float>(i);
    const FrontField whole = {x0, x0 + width, kKick, kTop, kUnitDepth};
    FrontField below = whole;
    below.y1 = kTop - 0.18f;
    FrontField above = whole;
    above.y0 = below.y1;
    switch (m.Below(4)) {
      case 0:
        Drawers(m, cabinet, above, 1);
        Drawers(m, cabinet, below, 2);
        break;
      case 1:
        Doors(m, cabinet, whole, width > 0.62f ? 2 : 1, HandleAt::kTop);
        break;
      case 2:
      case 3:
        Drawers(m, cabinet, above, 1);
        Doors(m, cabinet, below, width > 0.62f ? 2 : 1, HandleAt::kTop);
        break;
    }
  }
}

void WallUnits(PieceMaker& m, const Along& along, float bottom) {
  const Surface& cabinet = m.palette().cabinet;
  Body(m, cabinet, {along.x0, bottom, 0}, {along.x1, kWallUnitTop, kWallUnitDepth});
  const int doors = std::max(1, static_cast<int>(std::lround(along.width() / 0.45f)));
  Doors(m, cabinet, {along.x0, along.x1, bottom, kWallUnitTop, kWallUnitDepth}, doors,
        HandleAt::kBottom);
}

void PlainWorktop(PieceMaker& m, const Along& along) {
  m.Box(m.palette().counter, {along.x0, kWorktop - kWorktopThick, 0},
        {along.x1, kWorktop, kWorktopDepth});
}

void Backsplash(PieceMaker& m, const Along& along, float top) {
  Panel(m, m.palette().backsplash, {along.x0, kWorktop, 0}, {along.x1, top, 0.012f});
}

namespace {

/// Open shelves with plates instead of cabinets.
void OpenShelves(PieceMaker& m, const Along& along) {
  for (const float y : {1.45f, 1.8f}) {
    m.Box(m.palette().wood, {along.x0 + 0.05f, y, 0}, {along.x1 - 0.05f, y + 0.03f, 0.24f});
    for (const float x : Spaced(along.x0 + 0.2f, along.x1 - 0.15f, 0.26f)) {
      Ornament(m, {x, y + 0.03f, 0.13f}, {0.2f, 0.24f, 0.2f});
    }
  }
}

}  // namespace

void AboveWorktop(PieceMaker& m, const Along& along) {
  const bool has_cabinets = m.Fits(kWallUnitTop);
  const float top = has_cabinets ? kWallUnit : (m.Fits(1.3f) ? 1.3f : 0.98f);
  if (m.Fits(top)) Backsplash(m, along, top);
  if (!has_cabinets) return;
  if (m.Chance(0.15)) {
    OpenShelves(m, along);
  } else {
    WallUnits(m, along);
  }
}

namespace {

void KitchenCounter(PieceMaker& m) {
  const float width = m.Width(1.2f, 2.4f);
  const Along along = {-0.5f * width, 0.5f * width};
  BaseUnits(m, along);
  PlainWorktop(m, along);
  AboveWorktop(m, along);
  m.AddTop(kWorktop, {along.x0 + 0.02f, 0.05f}, {along.x1 - 0.02f, kWorktopDepth - 0.08f});
}

/// Worktop around a basin at `hole`, and the basin.
void SinkWorktop(PieceMaker& m, const Along& along, const Along& hole) {
  constexpr float kFront = 0.5f;
  constexpr float kRear = 0.13f;
  constexpr float kLow = kWorktop - kWorktopThick;
  const Surface& counter = m.palette().counter;
  m.Box(counter, {along.x0, kLow, 0}, {hole.x0, kWorktop, kWorktopDepth});
  m.Box(counter, {hole.x1, kLow, 0}, {along.x1, kWorktop, kWorktopDepth});
  m.Box(counter, {hole.x0, kLow, 0}, {hole.x1, kWorktop, kRear});
  m.Box(counter, {hole.x0, kLow, kFront}, {hole.x1, kWorktop, kWorktopDepth});
  const Surface basin = m.Chance(0.7) ? kSteel : m.palette().ceramic;
  Hollow(m, Shaded(basin, 0.85f), {hole.x0, kWorktop - 0.2f, kRear}, {hole.x1, kWorktop, kFront});
  constexpr float kRim = 0.03f;
  constexpr float kY = kWorktop + 0.006f;
  for (const float z : {kRear - kRim, kFront}) {
    m.Box(basin, {hole.x0 - kRim, kWorktop, z}, {hole.x1 + kRim, kY, z + kRim});
  }
  for (const float x : {hole.x0 - kRim, hole.x1}) {
    m.Box(basin, {x, kWorktop, kRear}, {x + kRim, kY, kFront});
  }
}

/// A wire rack with plates on edge.
void DishRack(PieceMaker& m, float x) {
  m.Box(kSteel, {x - 0.2f, kWorktop, 0.14f}, {x + 0.2f, kWorktop + 0.03f, 0.44f});
  for (int i = 0; i < 4; ++i) {
    const Frame frame(
        &m, Turned({x - 0.12f + 0.07f * static_cast<float>(i), kWorktop + 0.15f, 0.3f}, 0.0f, 0.0f,
                   -1.25f));
    m.Turn(m.palette().ceramic, {0, 0, 0}, {{0.12f, 0.014f}, {0.07f, 0.0f}, {0.0f, 0.0f}}, 8);
    m.Turn(m.palette().ceramic, {0, -0.005f, 0}, {{0.0f, 0.0f}, {0.07f, 0.0f}, {0.12f, 0.014f}}, 8);
  }
}

void KitchenSinkCounter(PieceMaker& m) {
  const float width = m.Width(1.0f, 1.8f);
  const Along along = {-0.5f * width, 0.5f * width};
  const bool is_left = m.Chance(0.5);
  const float middle = width > 1.2f ? (is_left ? -0.18f : 0.18f) * width : 0.0f;
  const Along hole = {middle - 0.24f, middle + 0.24f};
  BaseUnits(m, along);
  SinkWorktop(m, along, hole);
  Tap(m, {middle, kWorktop, 0.08f}, 0.28f, 0.2f);
  if (m.Fits(0.98f)) Backsplash(m, along, 0.98f);  // sinks like to be under windows
  const float far = middle > 0.0f ? along.x0 : along.x1;
  if (std::abs(far - middle) > 0.75f && m.Chance(0.6)) {
    DishRack(m, 0.5f * (far + middle) + (far > middle ? 0.12f : -0.12f));
  }
  m.Cylinder({"plastic", BrightColor(m)}, {hole.x1 + 0.06f, kWorktop, 0.08f}, 0.03f, 0.17f, 6);
  if (middle > 0.0f) m.AddTop(kWorktop, {hole.x1 + 0.1f, 0.1f}, {along.x1, 0.5f});
  if (middle < 0.0f) m.AddTop(kWorktop, {along.x0, 0.1f}, {hole.x0 - 0.1f, 0.5f});
}

void KitchenIsland(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.0f, 0.06f);
  const Along along = {-half, half};
  BaseUnits(m, along);
  // The other side overhangs for stools.
  constexpr float kOver = 0.28f;
  m.Box(m.palette().counter, {-half - 0.03f, kWorktop - kWorktopThick, -kOver},
        {half + 0.03f, kWorktop + 0.01f, kWorktopDepth});
  m.AddTop(kWorktop + 0.01f, {-half, -kOver}, {half, kWorktopDepth});
  const Surface& wood = m.palette().wood;
  m.Box(wood, {-half, 0, -0.02f}, {half, kWorktop - kWorktopThick, 0});
  for (const float x : {-half, half - 0.04f}) {
    m.Box(wood, {x, 0, -kOver + 0.03f}, {x + 0.04f, kWorktop - kWorktopThick, 0});
  }
}

/// Wall cabinets alone, y = 0 at their lower edge.
void WallCabinet(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.6f, 1.4f);
  const Frame frame(&m, {0, -kWallUnit, 0});
  WallUnits(m, {-half, half});
}

constexpr std::array kKinds = {
    FurnitureKind{"kitchen_counter", Placement::kAgainstWall, 0.9f, KitchenCounter, 0.3f, 4.2f},
    FurnitureKind{"kitchen_island", Placement::kFree, 0.9f, KitchenIsland, 1.0f, 2.4f},
    FurnitureKind{"kitchen_sink_counter", Placement::kAgainstWall, 0.9f, KitchenSinkCounter, 0.8f,
                  3.0f},
    FurnitureKind{"kitchen_wall_cabinet", Placement::kOnWall, 0.0f, WallCabinet, 0.3f, 3.0f}};

}  // namespace

std::span<const FurnitureKind> KitchenRuns() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
