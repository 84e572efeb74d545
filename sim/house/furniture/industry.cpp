// SPDX-License-Identifier: MIT
// Stores and workshops.
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr Surface kPallet{"weathered_wood"};

/// Goods on a pallet: one wrapped block, or cartons with gaps.
void Load(PieceMaker& m, const Vec& at, const Vec& size) {
  m.Block(kPallet, at, {size.x(), 0.13f, size.z()});
  const Vec foot = at + Vec(0, 0.13f, 0);
  const float high = size.y() - 0.13f;
  switch (m.Below(3)) {
    case 0: {
      const Surface wrapped{"plastic", MutedColor(m)};
      return m.Block(wrapped, foot, {0.95f * size.x(), high, 0.95f * size.z()});
    }
    case 1:
      for (const float side : {-0.25f, 0.25f}) {
        const float tall = high * m.Draw(0.6f, 1.0f);
        m.Block(kCardboard, foot + Vec(side * size.x(), 0, 0),
                {0.46f * size.x(), tall, 0.92f * size.z()});
      }
      return;
    case 2:
      for (const float side : {-0.24f, 0.24f}) {
        m.Cylinder({"plastic", BrightColor(m)}, foot + Vec(side * size.x(), 0, 0),
                   0.22f * std::min(size.x(), 2.0f * size.z()), std::min(high, 0.88f), 8);
      }
      return;
  }
}

/// Loads on one level of a rack, which reaches `half` to each side, at height y.
void LoadLevel(PieceMaker& m, float half, float deep, float y, float pitch) {
  const int loads = half > 1.0f ? 2 : 1;
  const float share = (2.0f * half - 0.25f) / static_cast<float>(loads);
  for (int k = 0; k < loads; ++k) {
    if (m.Chance(0.15)) continue;
    const float x = -half + 0.125f + share * (static_cast<float>(k) + 0.5f);
    const float tall = std::min(m.Draw(0.5f, 0.85f) * pitch, pitch - 0.2f);
    Load(m, {x, y, 0}, {0.9f * share, tall, 1.7f * deep});
  }
}

/// The beams that carry a level, y the height of their tops.
void CarryLevel(PieceMaker& m, float half, float deep, float y) {
  const Surface beams{"painted_wood", {226, 110, 32}};
  for (const float z : {-deep + 0.04f, deep - 0.04f}) {
    m.Box(beams, {-half + 0.1f, y - 0.12f, z - 0.03f}, {half - 0.1f, y, z + 0.03f});
  }
}

/// Uprights and beams with loads on them, as high as asked.
void PalletRack(PieceMaker& m) {
  const float half = 0.5f * m.Width(2.1f, 2.6f);
  const float high = m.request().height > 0.0f ? m.request().height : m.Draw(1.9f, 2.1f);
  constexpr float kDeep = 0.55f;
  const Surface posts{"painted_wood", m.Chance(0.5) ? Rgb8{40, 84, 150} : Rgb8{96, 100, 104}};
  for (const float x : {-half + 0.05f, half - 0.05f}) {
    for (const float z : {-kDeep + 0.05f, kDeep - 0.05f}) Post(m, posts, {x, 0, z}, 0.1f, high);
  }
  const auto levels = std::max(1, static_cast<int>(high / 1.35f));
  const float pitch = high / static_cast<float>(levels);
  for (int i = 0; i < levels; ++i) {
    const float y = i == 0 ? 0.0f : pitch * static_cast<float>(i);
    if (i > 0) CarryLevel(m, half, kDeep, y);
    LoadLevel(m, half, kDeep, y, pitch);
  }
}

/// A shelf of boards seen from both sides, with boxes on it.
void StoreRack(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.2f, 2.4f);
  const float high = m.request().height > 0.0f ? m.request().height : m.Draw(1.7f, 2.05f);
  constexpr float kDeep = 0.3f;
  const Surface steel = m.Chance(0.5) ? kGreyPlastic : Surface{"painted_wood", MutedColor(m)};
  for (const float x : {-half + 0.02f, half - 0.02f}) {
    for (const float z : {-kDeep + 0.02f, kDeep - 0.02f}) Post(m, steel, {x, 0, z}, 0.04f, high);
  }
  const int rows = std::max(3, static_cast<int>(high / 0.5f));
  const float pitch = high / static_cast<float>(rows);
  for (int r = 0; r < rows; ++r) {
    const float y = 0.08f + pitch * static_cast<float>(r);
    m.Box(steel, {-half, y, -kDeep}, {half, y + 0.03f, kDeep});
    const int boxes = std::max(2, static_cast<int>(2.0f * half / 0.6f));
    const float share = (2.0f * half - 0.1f) / static_cast<float>(boxes);
    for (int k = 0; k < boxes; ++k) {
      if (m.Chance(0.2)) continue;
      const float x = -half + 0.05f + share * (static_cast<float>(k) + 0.5f);
      const Surface box = m.Chance(0.6) ? kCardboard : Surface{"plastic", MutedColor(m)};
      m.Block(box, {x, y + 0.03f, 0},
              {0.85f * share, m.Draw(0.4f, 0.8f) * (pitch - 0.1f), 1.6f * kDeep});
    }
  }
}

void PalletStack(PieceMaker& m) {
  const float high = m.Draw(0.5f, 1.6f);
  const Vec2 foot = m.Draw(Vec2(1.1f, 0.8f), Vec2(1.25f, 1.0f));
  Load(m, {0, 0, 0}, {foot.x(), high, foot.y()});
}

void Workbench(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.5f, 2.2f);
  const Surface top = m.Chance(0.6) ? m.palette().wood : kSteel;
  const Surface steel{"painted_wood", MutedColor(m)};
  m.Box(top, {-half, 0.82f, 0}, {half, 0.88f, 0.7f});
  for (const float x : {-half + 0.04f, half - 0.04f}) {
    for (const float z : {0.05f, 0.64f}) Post(m, steel, {x, 0, z}, 0.07f, 0.82f);
  }
  m.Box(steel, {-half + 0.08f, 0.2f, 0.1f}, {half - 0.08f, 0.23f, 0.6f});
  if (m.Chance(0.5)) m.Box(steel, {half - 0.62f, 0.24f, 0.1f}, {half - 0.1f, 0.8f, 0.62f});
  m.Box(steel, {-half, 0.88f, 0}, {half, 1.55f, 0.03f});  // tools hang there
  for (int i = 0; i < 5; ++i) {
    const float x = half * (0.38f * static_cast<float>(i) - 0.8f);
    const float y = m.Draw(1.0f, 1.2f);
    const Surface tool = m.Chance(0.5) ? kDark : Surface{"plastic", BrightColor(m)};
    const Vec2 size = m.Draw(Vec2(0.04f, 0.15f), Vec2(0.12f, 0.3f));
    Panel(m, tool, {x, y, 0.03f}, {x + size.x(), y + size.y(), 0.05f});
  }
  const Surface box{"plastic", BrightColor(m)};
  m.Block(box, {m.Draw(-0.5f, 0.5f) * half, 0.88f, 0.4f}, {0.4f, 0.2f, 0.22f});
  m.AddTop(0.88f, {-half, 0.1f}, {half, 0.7f});
}

/// Something large that turns, presses or cuts: a body, a head, a panel.
void Machine(PieceMaker& m) {
  const float x = 0.5f * m.Draw(1.0f, 2.0f);
  const float z = 0.5f * m.Draw(0.8f, 1.3f);
  const float bed = m.Draw(0.7f, 1.0f);
  const float high = m.Draw(1.4f, 2.0f);
  const Surface body{"painted_wood", m.Chance(0.5) ? MutedColor(m) : Rgb8{188, 194, 190}};
  m.Box(Shaded(body, 0.7f), {-x, 0, -z}, {x, 0.12f, z});
  m.Box(body, {-x + 0.04f, 0.12f, -z + 0.04f}, {x - 0.04f, bed, z - 0.04f});
  m.Box(kSteel, {-x + 0.1f, bed, -z + 0.1f}, {x - 0.1f, bed + 0.08f, z - 0.1f});
  const float head = m.Draw(0.3f, 0.6f) * x;
  m.Box(body, {-x + 0.05f, bed + 0.08f, -z + 0.06f}, {-x + 0.05f + head, high, 0.6f * z});
  if (m.Chance(0.6))
    m.Box(body, {-x + 0.05f + head, high - 0.3f, -z + 0.1f}, {0.7f * x, high, 0.4f * z});
  Panel(m, kBlackPlastic, {-x + 0.1f, bed + 0.35f, 0.6f * z},
        {-x + head, bed + 0.6f, 0.6f * z + 0.02f});
  m.Cylinder({"plastic", {220, 40, 30}}, {x - 0.2f, bed + 0.08f, z - 0.2f}, 0.05f, 0.1f, 6);
}

void Drums(PieceMaker& m) {
  const int count = m.Between(2, 4);
  const Surface steel{"painted_wood", BrightColor(m)};
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i % 2);
    const int row = i / 2;
    const auto z = static_cast<float>(row);
    m.Cylinder(steel, {0.62f * x, 0, 0.62f * z}, 0.29f, m.Draw(0.84f, 0.9f), 10);
  }
}

/// A truck with a mast and forks.
void Forklift(PieceMaker& m) {
  const Surface body{"painted_wood", m.Chance(0.5) ? Rgb8{232, 170, 30} : Rgb8{210, 60, 40}};
  const float half = 0.5f * m.Draw(1.0f, 1.15f);
  m.Box(body, {-half, 0.15f, -0.9f}, {half, 0.75f, 0.35f});
  m.Box(kDark, {-half + 0.08f, 0.75f, -0.9f}, {half - 0.08f, 1.05f, -0.45f});
  for (const float x : {-half + 0.06f, half - 0.06f}) {
    Post(m, kDark, {x, 0.75f, -0.4f}, 0.07f, 1.25f);
    Post(m, kDark, {x, 0.75f, 0.3f}, 0.07f, 1.25f);
    m.Box(kBlackMetal, {x - 0.05f, 0.02f, 0.4f}, {x + 0.05f, 2.05f, 0.5f});
    m.Box(kRubber, {x - 0.06f, 0, -0.75f}, {x + 0.06f, 0.4f, -0.35f});
    m.Box(kRubber, {x - 0.06f, 0, 0.0f}, {x + 0.06f, 0.45f, 0.34f});
    m.Box(kSteel, {0.55f * x - 0.06f, 0.04f, 0.5f}, {0.55f * x + 0.06f, 0.09f, 1.15f});
  }
  m.Box(body, {-half, 2.0f, -0.45f}, {half, 2.06f, 0.36f});
}

constexpr std::array kKinds = {
    FurnitureKind{"drums", Placement::kFree, 0.2f, Drums},
    FurnitureKind{"forklift", Placement::kFree, 0.4f, Forklift},
    FurnitureKind{"machine", Placement::kFree, 0.5f, Machine},
    FurnitureKind{"pallet_rack", Placement::kFree, 0.0f, PalletRack, 1.6f, 3.0f},
    FurnitureKind{"pallet_stack", Placement::kFree, 0.2f, PalletStack},
    FurnitureKind{"store_rack", Placement::kFree, 0.0f, StoreRack, 0.9f, 3.0f},
    FurnitureKind{"workbench", Placement::kAgainstWall, 0.7f, Workbench, 1.2f, 3.0f}};

}  // namespace

std::span<const FurnitureKind> Industry() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
