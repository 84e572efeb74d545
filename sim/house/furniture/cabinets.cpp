// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

Surface CabinetSurface(PieceMaker& m) {
  return m.Chance(0.5) ? m.palette().wood : m.palette().cabinet;
}

void Nightstand(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float half = 0.5f * m.Draw(0.4f, 0.52f);
  const float depth = m.Draw(0.36f, 0.42f);
  const float height = m.Draw(0.46f, 0.6f);
  const float foot = m.Draw(0.08f, 0.18f);
  Legs(m, surface, {DrawLegStyle(m), {-half, 0}, {half, depth}, foot, 0.04f});
  if (m.Chance(0.5)) {
    Body(m, surface, {-half, foot, 0}, {half, height - 0.03f, depth});
    Drawers(m, surface, {-half, half, foot, height - 0.03f, depth}, 2);
  } else {  // a drawer over an open shelf
    const float shelf = height - 0.2f;
    OpenBody(m, surface, {-half, foot, 0}, {half, shelf, depth}, 0.025f);
    Books(m, {-half + 0.05f, foot + 0.025f, 0.1f}, {half - 0.1f, shelf - 0.02f, depth - 0.05f});
    Body(m, surface, {-half, shelf, 0}, {half, height - 0.03f, depth});
    Drawers(m, surface, {-half, half, shelf, height - 0.03f, depth}, 1);
  }
  m.Box(surface, {-half - 0.015f, height - 0.03f, 0}, {half + 0.015f, height, depth + 0.02f});
  m.AddTop(height, {-half, 0.0f}, {half, depth});
}

/// Sliding panels in a frame; one may be a mirror.
void SlidingDoors(PieceMaker& m, const Surface& surface, const FrontField& f, int count) {
  const float width = (f.x1 - f.x0) / static_cast<float>(count);
  const int mirror = m.Chance(0.6) ? m.Below(count) : -1;
  for (int i = 0; i < count; ++i) {
    const float x = f.x0 + width * static_cast<float>(i);
    const float z = f.z + (i % 2 == 0 ? 0.01f : 0.03f);
    m.Box(kSteel, {x, f.y0, z - 0.01f}, {x + width, f.y1, z});
    const Surface panel = i == mirror ? kMirror : surface;
    m.Quad(panel, {x + 0.025f, f.y0 + 0.025f, z + 0.003f},
           {x + width - 0.025f, f.y0 + 0.025f, z + 0.003f},
           {x + width - 0.025f, f.y1 - 0.025f, z + 0.003f},
           {x + 0.025f, f.y1 - 0.025f, z + 0.003f});
  }
}

/// No doors: clothes on a rail over drawers.
void OpenWardrobe(PieceMaker& m, const Surface& surface, float half, float height, float depth) {
  constexpr float kSill = 0.5f;
  OpenBody(m, surface, {-half, kSill, 0}, {half, height, depth}, 0.03f);
  Body(m, surface, {-half, 0, 0}, {half, kSill, depth});
  const int columns = std::max(2, static_cast<int>(std::lround(2.0f * half / 0.6f)));
  const float width = 2.0f * half / static_cast<float>(columns);
  for (int i = 0; i < columns; ++i) {
    const float x = -half + width * static_cast<float>(i);
    Drawers(m, surface, {x, x + width, 0.04f, kSill, depth}, 2);
    if (i > 0)
      m.Box(surface, {x - 0.015f, kSill, 0.02f}, {x + 0.015f, height - 0.03f, depth - 0.01f});
    const float from = m.Draw(0.0f, 0.6f);
    const float low = kSill + m.Draw(0.03f, 0.1f);
    m.Picture({"clothes"}, {x + 0.03f, low, 0.55f * depth}, {x + width - 0.03f, low, 0.55f * depth},
              {x + width - 0.03f, height - 0.15f, 0.55f * depth},
              {x + 0.03f, height - 0.15f, 0.55f * depth},
              {Vec2(from, 0), Vec2(from + 0.7f * width, 1)});
  }
}

void Wardrobe(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float width = m.Width(0.95f, 2.3f, 0.06f);
  const float half = 0.5f * width;
  const float height = m.Draw(1.95f, 2.25f);
  const float depth = m.Draw(0.55f, 0.62f);
  if (m.Chance(0.15)) return OpenWardrobe(m, surface, half, height, depth);
  constexpr float kPlinth = 0.08f;
  m.Box(Shaded(surface, 0.6f), {-half + 0.02f, 0, 0}, {half - 0.02f, kPlinth, depth - 0.04f});
  Body(m, surface, {-half, kPlinth, 0}, {half, height, depth});
  const FrontField front = {-half, half, kPlinth, height, depth};
  if (width > 1.3f && m.Chance(0.35)) {
    SlidingDoors(m, surface, front, width > 2.2f ? 3 : 2);
  } else {
    const int doors = std::max(2, static_cast<int>(std::lround(width / 0.5f)));
    float sill = kPlinth;
    if (m.Chance(0.35)) {
      sill += 0.4f;
      Drawers(m, surface, {-half, 0, kPlinth, sill, depth}, 2);
      Drawers(m, surface, {0, half, kPlinth, sill, depth}, 2);
    }
    Doors(m, surface, {-half, half, sill, height, depth}, doors);
    if (m.Chance(0.3)) {  // a mirror on a door
      const float leaf = width / static_cast<float>(doors);
      Sheet(m, kMirror, {-half + 0.5f * leaf - 0.02f, sill + 0.15f, depth + 0.025f}, leaf - 0.2f,
            height - sill - 0.3f);
    }
  }
  if (m.palette().framed_fronts) {  // a cornice
    m.Box(surface, {-half - 0.03f, height, 0}, {half + 0.03f, height + 0.06f, depth + 0.04f});
  }
}

void Dresser(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float half = 0.5f * m.Draw(0.8f, 1.4f);
  const float depth = m.Draw(0.42f, 0.5f);
  const float height = m.Draw(0.78f, 1.0f);
  const float foot = m.Draw(0.06f, 0.16f);
  const int rows = height > 0.88f ? 4 : 3;
  Legs(m, surface, {DrawLegStyle(m), {-half, 0}, {half, depth}, foot, 0.05f});
  Body(m, surface, {-half, foot, 0}, {half, height - 0.03f, depth});
  if (half > 0.52f) {
    Drawers(m, surface, {-half, 0, foot, height - 0.03f, depth}, rows);
    Drawers(m, surface, {0, half, foot, height - 0.03f, depth}, rows);
  } else {
    Drawers(m, surface, {-half, half, foot, height - 0.03f, depth}, rows);
  }
  m.Box(surface, {-half - 0.02f, height - 0.03f, 0}, {half + 0.02f, height, depth + 0.02f});
  m.AddTop(height, {-half, 0.0f}, {half, depth});
}

void VanityMirror(PieceMaker& m, const Surface& frame_surface, float bottom) {
  if (m.Chance(0.5)) {  // oval, on edge: a disc that looks to the front
    Eigen::Affine3f oval = Turned({0, bottom + 0.38f, 0.06f}, 0.0f, kQuarterTurn);
    oval = oval * Eigen::Scaling(Vec(0.78f, 1.0f, 1.0f));
    const Frame frame(&m, oval);
    m.Cylinder(frame_surface, {0, -0.03f, 0}, 0.38f, 0.03f, 16);
    PictureDisc(m, kMirror, {0, 0.004f, 0}, 0.33f, 16);
    return;
  }
  for (const float x : {-0.33f, 0.0f, 0.33f}) {  // three wings
    const bool is_middle = x == 0.0f;
    const float width = is_middle ? 0.42f : 0.24f;
    const Frame frame(&m, Turned({x, bottom, is_middle ? 0.03f : 0.07f}, -0.9f * x / 0.33f * 0.5f));
    const float height = is_middle ? 0.7f : 0.58f;
    Panel(m, frame_surface, {-0.5f * width, 0.03f, -0.01f}, {0.5f * width, height, 0.012f});
    Sheet(m, kMirror, {0, 0.07f, 0.016f}, width - 0.07f, height - 0.11f);
  }
}

void VanityTable(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float half = 0.5f * m.Draw(0.9f, 1.15f);
  constexpr float kDepth = 0.44f;
  constexpr float kHeight = 0.76f;
  Legs(m, surface, {LegStyle::kTapered, {-half, 0}, {half, kDepth}, 0.62f, 0.05f});
  Body(m, surface, {-half, 0.6f, 0}, {half, kHeight - 0.025f, kDepth});
  for (const float x : {-half, -half / 3.0f, half / 3.0f}) {
    Drawers(m, surface, {x, x + 2.0f / 3.0f * half, 0.6f, kHeight - 0.025f, kDepth}, 1);
  }
  m.Box(surface, {-half - 0.01f, kHeight - 0.025f, 0}, {half + 0.01f, kHeight, kDepth + 0.02f});
  VanityMirror(m, surface, kHeight);
  // Bottles and jars of make-up.
  for (int i = 0; i < 4; ++i) {
    const float x = m.Draw(0.35f, 0.9f) * (i % 2 == 0 ? half : -half);
    const Surface plastic{"plastic", BrightColor(m)};
    const float z = m.Draw(0.15f, 0.3f);
    m.Cylinder(plastic, {x, kHeight, z}, 0.022f, m.Draw(0.06f, 0.16f), 5);
  }
  // The stool, half under the table.
  Legs(m, surface, {LegStyle::kTapered, {-0.21f, 0.3f}, {0.21f, 0.66f}, 0.4f, 0.04f});
  Cushion(m, m.palette().accent, {-0.23f, 0.4f, 0.28f}, {0.23f, 0.48f, 0.68f}, 0.03f);
}

void Sideboard(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float half = 0.5f * m.Width(1.3f, 1.9f, 0.04f);
  const float depth = m.Draw(0.4f, 0.48f);
  const float height = m.Draw(0.74f, 0.9f);
  const float foot = m.Draw(0.08f, 0.2f);
  Legs(m, m.Chance(0.5) ? surface : m.palette().metal,
       {DrawLegStyle(m), {-half + 0.05f, 0.02f}, {half - 0.05f, depth - 0.02f}, foot, 0.05f});
  Body(m, surface, {-half, foot, 0}, {half, height - 0.03f, depth});
  const float third = half / 3.0f;
  const float top = height - 0.03f;
  const int style = m.Below(3);
  if (style == 0) {
    Doors(m, surface, {-half, -third, foot, top, depth}, 1, HandleAt::kTop);
    Drawers(m, surface, {-third, third, foot, top, depth}, 3);
    Doors(m, surface, {third, half, foot, top, depth}, 1, HandleAt::kTop);
  } else if (style == 1) {
    Doors(m, surface, {-half, half, foot, top, depth}, 4, HandleAt::kTop);
  } else {
    Drawers(m, surface, {-half, 0, top - 0.18f, top, depth}, 1);
    Drawers(m, surface, {0, half, top - 0.18f, top, depth}, 1);
    Doors(m, surface, {-half, half, foot, top - 0.18f, depth}, 4, HandleAt::kTop);
  }
  m.Box(m.palette().wood, {-half - 0.02f, top, 0}, {half + 0.02f, height, depth + 0.02f});
  m.AddTop(height, {-half, 0.0f}, {half, depth});
}

/// Plates on edge and cups along one shelf.
void Crockery(PieceMaker& m, float half, float y, float depth) {
  const Surface& ceramic = m.palette().ceramic;
  for (const float x : Spaced(-half + 0.12f, half - 0.08f, 0.2f)) {
    if (m.Chance(0.4)) {
      const Frame frame(&m, Turned({x, y + 0.11f, 0.12f}, 0.0f, kQuarterTurn - 0.25f));
      m.Turn(ceramic, {0, 0, 0}, {{0.11f, 0.01f}, {0.06f, 0.0f}, {0.0f, 0.0f}}, 8);
    } else {
      const Surface pot = m.Chance(0.5) ? ceramic : Surface{"ceramic", MutedColor(m)};
      m.Turn(pot, {x, y, 0.5f * depth}, {{0.04f, 0.0f}, {0.07f, 0.06f}, {0.055f, 0.13f}}, 6);
    }
  }
}

/// Cupboard below, glazed shelves with crockery above. The panes are left out: they would hide it.
void DisplayCabinet(PieceMaker& m) {
  const Surface surface = CabinetSurface(m);
  const float half = 0.5f * m.Draw(0.85f, 1.25f);
  const float height = m.Draw(1.75f, 2.05f);
  constexpr float kDepth = 0.4f;
  constexpr float kCounter = 0.8f;
  m.Box(Shaded(surface, 0.7f), {-half + 0.02f, 0, 0}, {half - 0.02f, 0.08f, kDepth - 0.03f});
  Body(m, surface, {-half, 0.08f, 0}, {half, kCounter, kDepth});
  Doors(m, surface, {-half, half, 0.08f, kCounter - 0.02f, kDepth}, 2, HandleAt::kTop);
  m.Box(surface, {-half - 0.02f, kCounter, 0}, {half + 0.02f, kCounter + 0.03f, kDepth + 0.02f});
  const float depth = kDepth - 0.08f;
  OpenBody(m, surface, {-half, kCounter + 0.03f, 0}, {half, height, depth}, 0.03f);
  for (int i = 0; i < 3; ++i) {
    const float y = kCounter + 0.06f + static_cast<float>(i) * (height - kCounter - 0.06f) / 3.0f;
    if (i > 0) m.Box(surface, {-half + 0.03f, y - 0.02f, 0.01f}, {half - 0.03f, y, depth - 0.04f});
    Crockery(m, half, y, depth);
  }
  for (const float x : {-half, -0.05f, 0.0f, half - 0.05f}) {  // the stiles of the doors
    m.Box(surface, {x, kCounter + 0.03f, depth}, {x + 0.048f, height, depth + 0.02f});
  }
  for (const float y : {kCounter + 0.03f, height - 0.05f}) {
    m.Box(surface, {-half + 0.05f, y, depth + 0.001f}, {half - 0.05f, y + 0.05f, depth + 0.019f});
  }
  m.Box(surface, {-half - 0.03f, height, 0}, {half + 0.03f, height + 0.04f, depth + 0.04f});
}

constexpr std::array kKinds = {
    FurnitureKind{"display_cabinet", Placement::kAgainstWall, 0.7f, DisplayCabinet},
    FurnitureKind{"dresser", Placement::kAgainstWall, 0.7f, Dresser},
    FurnitureKind{"nightstand", Placement::kAgainstWall, 0.3f, Nightstand},
    FurnitureKind{"sideboard", Placement::kAgainstWall, 0.7f, Sideboard, 0.9f, 2.4f},
    FurnitureKind{"vanity_table", Placement::kAgainstWall, 0.6f, VanityTable},
    FurnitureKind{"wardrobe", Placement::kAgainstWall, 0.7f, Wardrobe, 0.7f, 3.2f}};

}  // namespace

std::span<const FurnitureKind> Cabinets() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
