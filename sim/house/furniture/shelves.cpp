// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kBoard = 0.03f;

/// One compartment of a shelf: books, an ornament with books, or a few ornaments.
void Fill(PieceMaker& m, const Vec& low, const Vec& high) {
  const float width = high.x() - low.x();
  const Vec size(std::min(0.3f, 0.4f * width), high.y() - low.y(), high.z() - low.z());
  const float z = 0.55f * (low.z() + high.z());
  const double what = m.rng().Uniform();
  if (what < 0.55 || width < 0.3f) {
    Books(m, {low.x(), low.y(), low.z() + 0.05f}, high);
  } else if (what < 0.85) {
    const float split = low.x() + m.Draw(0.45f, 0.65f) * width;
    Books(m, {low.x(), low.y(), low.z() + 0.05f}, {split, high.y(), high.z()});
    Ornament(m, {0.5f * (split + high.x()), low.y(), z}, size);
  } else {
    Ornament(m, {low.x() + 0.28f * width, low.y(), z}, size);
    Ornament(m, {low.x() + 0.72f * width, low.y(), z}, size);
  }
}

/// Boards in columns, open to the front, filled.
struct ShelfShape {
  float half = 0.5f;
  float bottom = 0.0f;
  float top = 1.9f;
  float depth = 0.3f;
  int rows = 5;
  int columns = 1;
};

void FilledShelf(PieceMaker& m, const Surface& surface, const ShelfShape& s) {
  OpenBody(m, surface, {-s.half, s.bottom, 0}, {s.half, s.top, s.depth}, kBoard);
  const float pitch = (s.top - s.bottom - kBoard) / static_cast<float>(s.rows);
  const float column = (2.0f * s.half - kBoard) / static_cast<float>(s.columns);
  for (int r = 1; r < s.rows; ++r) {
    const float y = s.bottom + pitch * static_cast<float>(r);
    m.Box(surface, {-s.half + kBoard, y, 0.02f}, {s.half - kBoard, y + kBoard, s.depth - 0.01f});
  }
  for (int c = 0; c < s.columns; ++c) {
    const float x = -s.half + column * static_cast<float>(c);
    if (c > 0) {
      m.Box(surface, {x, s.bottom + kBoard, 0.02f}, {x + kBoard, s.top - kBoard, s.depth - 0.01f});
    }
    for (int r = 0; r < s.rows; ++r) {
      if (m.Chance(0.1)) continue;
      const float y = s.bottom + pitch * static_cast<float>(r);
      Fill(m, {x + kBoard + 0.01f, y + kBoard, 0.03f}, {x + column - 0.01f, y + pitch, s.depth});
    }
  }
}

void Bookshelf(PieceMaker& m) {
  ShelfShape s;
  const float width = m.Width(0.7f, 1.6f);
  s.half = 0.5f * width;
  s.top = m.Draw(1.75f, 2.1f);
  s.depth = m.Draw(0.26f, 0.34f);
  s.columns = std::max(1, static_cast<int>(std::lround(width / 0.8f)));
  s.rows = m.Between(5, 6);
  const Surface surface = m.Chance(0.3) ? m.palette().cabinet : m.palette().wood;
  if (m.Chance(0.3)) {  // doors below
    s.bottom = 0.7f;
    s.rows = 4;
    Body(m, surface, {-s.half, 0, 0}, {s.half, s.bottom, s.depth + 0.04f});
    Doors(m, surface, {-s.half, s.half, 0.06f, s.bottom, s.depth + 0.04f},
          std::max(2, 2 * s.columns), HandleAt::kTop);
  }
  FilledShelf(m, surface, s);
}

void LowShelf(PieceMaker& m) {
  ShelfShape s;
  const float width = m.Width(0.8f, 1.5f);
  s.half = 0.5f * width;
  s.top = m.Draw(0.7f, 0.85f);
  s.depth = m.Draw(0.3f, 0.38f);
  s.rows = 2;
  s.columns = std::max(2, static_cast<int>(std::lround(width / 0.4f)));
  FilledShelf(m, m.Chance(0.5) ? m.palette().cabinet : m.palette().wood, s);
  m.AddTop(s.top, {-s.half, 0.0f}, {s.half, s.depth});
}

void Packets(PieceMaker& m, const Vec& low, const Vec& high) {
  const float top = low.y() + m.Draw(0.6f, 0.85f) * (high.y() - low.y());
  const float z = high.z() - 0.04f;
  Panel(m, kPaper, low, {high.x(), top, z - 0.005f});
  m.Picture({"food_boxes"}, {low.x(), low.y(), z}, {high.x(), low.y(), z}, {high.x(), top, z},
            {low.x(), top, z}, {Vec2(0, 0), Vec2(high.x() - low.x(), 1.0f)});
}

void BottleRow(PieceMaker& m, const Vec& low, const Vec& high) {
  const Surface glass{"glass", m.Chance(0.5) ? Rgb8{60, 110, 60} : Rgb8{140, 60, 40}};
  const float tall = high.y() - low.y();
  const float pitch = std::max(0.1f, (high.x() - low.x()) / 2.8f);
  for (const float x : Spaced(low.x() + 0.05f, high.x() - 0.04f, pitch)) {
    m.Turn(glass, {x, low.y(), high.z() - 0.1f},
           {{0.04f, 0.0f}, {0.04f, 0.55f * tall}, {0.014f, 0.7f * tall}, {0.014f, 0.9f * tall}}, 5);
  }
}

void JarRow(PieceMaker& m, const Vec& low, const Vec& high) {
  const float pitch = std::max(0.13f, (high.x() - low.x()) / 2.5f);
  for (const float x : Spaced(low.x() + 0.06f, high.x() - 0.05f, pitch)) {
    const float height = m.Draw(0.4f, 0.6f) * (high.y() - low.y());
    const Vec foot(x, low.y(), high.z() - 0.12f);
    m.Turn({"glass", MutedColor(m)}, foot, {{0.052f, 0.0f}, {0.052f, height}, {0.0f, height}}, 6);
    const float lid = height + 0.01f;
    m.Turn(m.palette().metal, foot, {{0.054f, height - 0.02f}, {0.054f, lid}, {0.0f, lid}}, 6);
  }
}

/// Something of a larder that fits between two corners.
void Groceries(PieceMaker& m, const Vec& low, const Vec& high) {
  switch (m.Below(4)) {
    case 0:
      return Packets(m, low, high);
    case 1:
      return BottleRow(m, low, high);
    case 2:
      return JarRow(m, low, high);
    case 3: {  // a basket
      const Vec foot(0.5f * (low.x() + high.x()), low.y(), 0.5f * (low.z() + high.z()));
      const Vec2 size(0.85f * (high.x() - low.x()), 0.75f * (high.z() - low.z()));
      const Vec top = foot + Vec(0, 0.55f * (high.y() - low.y()), 0);
      return m.TaperedBox(kWicker, foot, 0.85f * size, top, size);
    }
  }
}

void PantryShelf(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.7f, 1.2f);
  const float top = m.Draw(1.75f, 2.05f);
  const float depth = m.Draw(0.32f, 0.42f);
  const Surface surface = m.Chance(0.5) ? m.palette().wood : m.palette().cabinet;
  OpenBody(m, surface, {-half, 0, 0}, {half, top, depth}, kBoard);
  constexpr int kRows = 5;
  const float pitch = (top - kBoard) / static_cast<float>(kRows);
  for (int r = 0; r < kRows; ++r) {
    const float y = pitch * static_cast<float>(r);
    if (r > 0)
      m.Box(surface, {-half + kBoard, y, 0.02f}, {half - kBoard, y + kBoard, depth - 0.01f});
    const int groups = half > 0.45f ? 3 : 2;
    const float width = 2.0f * (half - kBoard) / static_cast<float>(groups);
    for (int g = 0; g < groups; ++g) {
      const float x = -half + kBoard + width * static_cast<float>(g);
      Groceries(m, {x + 0.02f, y + kBoard, 0.04f}, {x + width - 0.02f, y + pitch, depth});
    }
  }
}

/// What stands about in a store room.
void Supplies(PieceMaker& m, const Vec& at, float width, float tall) {
  const float depth = m.Draw(0.28f, 0.36f);
  const float height = m.Draw(0.5f, 0.8f) * tall;
  switch (m.Below(4)) {
    case 0:  // a carton, taped
      m.Block(kCardboard, at, {0.9f * width, height, depth});
      m.Block(Shaded(kCardboard, 0.8f), at + Vec(0, 0, 0.002f),
              {0.05f, height + 0.003f, depth + 0.004f});
      break;
    case 1: {  // a plastic crate with its lid
      const Surface crate{"plastic", BrightColor(m)};
      const Vec top = at + Vec(0, height, 0);
      m.TaperedBox(crate, at, {0.8f * width, 0.85f * depth}, top, {0.92f * width, depth});
      m.Block(kWhitePlastic, top, {0.95f * width, 0.02f, depth + 0.02f});
      break;
    }
    case 2:  // tins of paint
      for (const float side : {-0.24f, 0.24f}) {
        const Vec foot = at + Vec(side * width, 0, 0.05f);
        m.Cylinder(kSteel, foot, 0.085f, 0.19f, 8);
        m.Cylinder({"plastic", MutedColor(m)}, foot + Vec(0, 0.03f, 0), 0.088f, 0.12f, 8);
      }
      break;
    case 3:
      m.Block({"canvas", MutedColor(m)}, at, {0.85f * width, 0.7f * height, depth});
      break;
  }
}

void UtilityShelf(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.8f, 1.3f);
  const float top = m.Draw(1.7f, 1.95f);
  constexpr float kDepth = 0.42f;
  const Surface posts = m.Chance(0.5) ? kSteel : kBlackMetal;
  const Surface& boards = m.Chance(0.5) ? posts : m.palette().wood;
  for (const float x : {-half + 0.02f, half - 0.02f}) {
    for (const float z : {0.02f, kDepth - 0.02f}) Post(m, posts, {x, 0, z}, 0.04f, top);
  }
  constexpr int kRows = 4;
  for (int r = 0; r <= kRows; ++r) {
    const float pitch = (top - 0.2f) / static_cast<float>(kRows);
    const float y = 0.12f + pitch * static_cast<float>(r);
    m.Box(boards, {-half, y, 0}, {half, y + 0.03f, kDepth});
    if (r == kRows) break;
    const int groups = half > 0.5f ? 3 : 2;
    const float width = (2.0f * half - 0.08f) / static_cast<float>(groups);
    for (int g = 0; g < groups; ++g) {
      if (m.Chance(0.15)) continue;
      const float x = -half + 0.04f + width * (static_cast<float>(g) + 0.5f);
      Supplies(m, {x, y + 0.03f, 0.5f * kDepth}, width, pitch);
    }
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"bookshelf", Placement::kAgainstWall, 0.6f, Bookshelf, 0.5f, 2.6f},
    FurnitureKind{"low_shelf", Placement::kAgainstWall, 0.5f, LowShelf, 0.6f, 2.0f},
    FurnitureKind{"pantry_shelf", Placement::kAgainstWall, 0.6f, PantryShelf, 0.6f, 1.8f},
    FurnitureKind{"utility_shelf", Placement::kAgainstWall, 0.6f, UtilityShelf, 0.7f, 2.0f}};

}  // namespace

std::span<const FurnitureKind> Shelves() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
