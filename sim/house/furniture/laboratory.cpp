// SPDX-License-Identifier: MIT
// Benches of laboratories and what stands on them.
#include <algorithm>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kBenchTop = 0.9f;

Surface BenchTop(PieceMaker& m) {
  return m.Chance(0.5) ? Surface{"plastic", {58, 60, 64}} : Surface{"plastic", {214, 218, 218}};
}

void Microscope(PieceMaker& m, const Vec& at) {
  const Frame frame(&m, at, m.Draw(-0.4f, 0.4f));
  m.Box(kWhitePlastic, {-0.08f, 0, -0.12f}, {0.08f, 0.05f, 0.1f});
  m.Box(kWhitePlastic, {-0.04f, 0.05f, -0.12f}, {0.04f, 0.3f, -0.05f});
  m.Box(kBlackPlastic, {-0.07f, 0.14f, -0.06f}, {0.07f, 0.16f, 0.08f});
  m.Bar(kBlackPlastic, {0, 0.2f, 0}, {0, 0.38f, 0.06f}, 0.03f, 6);
}

/// Flasks, bottles and racks.
void Glassware(PieceMaker& m, const Vec& at) {
  switch (m.Below(3)) {
    case 0:
      return m.Turn(kGlass, at,
                    {{0.07f, 0.0f}, {0.07f, 0.02f}, {0.02f, 0.13f}, {0.02f, 0.2f}, {0.0f, 0.2f}},
                    6);
    case 1:
      return m.Cylinder({"plastic", m.Chance(0.5) ? Rgb8{120, 72, 30} : BrightColor(m)}, at, 0.045f,
                        0.17f, 8);
    default:
      m.Box({"plastic", BrightColor(m)}, at + Vec(-0.12f, 0, -0.04f),
            at + Vec(0.12f, 0.06f, 0.04f));
      for (const float x : {-0.08f, 0.0f, 0.08f})
        m.Cylinder(kGlass, at + Vec(x, 0.06f, 0), 0.01f, 0.09f, 4);
  }
}

/// A box with a lid, dials and a display: balances, centrifuges, baths.
void Instrument(PieceMaker& m, const Vec& at) {
  const Vec2 size = m.Draw(Vec2(0.28f, 0.2f), Vec2(0.48f, 0.42f));
  const float half = 0.5f * size.x();
  const Frame frame(&m, at);
  m.Box(m.Chance(0.6) ? kWhitePlastic : kGreyPlastic, {-half, 0, -0.2f}, {half, size.y(), 0.18f});
  Panel(m, kDark, {-0.7f * half, 0.55f * size.y(), 0.18f}, {0.2f * half, 0.85f * size.y(), 0.185f});
  Panel(m, {"plastic", BrightColor(m)}, {0.5f * half, 0.6f * size.y(), 0.18f},
        {0.75f * half, 0.75f * size.y(), 0.19f});
}

void Apparatus(PieceMaker& m, const Vec& at) {
  switch (m.Below(4)) {
    case 0:
      return Microscope(m, at);
    case 1:
      return Instrument(m, at);
    default:
      return Glassware(m, at);
  }
}

void Stool(PieceMaker& m, const Vec& at) {
  const Surface seat = m.Chance(0.5) ? kBlackPlastic : m.palette().wood;
  m.Cylinder(seat, at + Vec(0, 0.58f, 0), 0.17f, 0.05f, 8);
  for (const float x : {-0.12f, 0.12f}) {
    for (const float z : {-0.12f, 0.12f}) Post(m, kBlackMetal, at + Vec(x, 0, z), 0.025f, 0.58f);
  }
}

/// Benches back to back with a shelf over their middle, stools before both.
void LabBench(PieceMaker& m) {
  const float width = m.Width(1.8f, 2.5f);
  const float half = 0.5f * width;
  constexpr float kDeep = 0.68f;
  const Surface& body = m.palette().cabinet;
  const Surface top = BenchTop(m);
  m.Box(kDark, {-half + 0.06f, 0, -kDeep + 0.1f}, {half - 0.06f, 0.1f, kDeep - 0.1f});
  m.Box(body, {-half + 0.03f, 0.1f, -kDeep + 0.06f},
        {half - 0.03f, kBenchTop - 0.04f, kDeep - 0.06f});
  m.Box(top, {-half, kBenchTop - 0.04f, -kDeep}, {half, kBenchTop, kDeep});
  const int doors = std::max(2, static_cast<int>(width / 0.55f));
  const bool has_shelf = m.Chance(0.7);
  const float shelf = kBenchTop + m.Draw(0.35f, 0.5f);
  if (has_shelf) {
    for (const float x : {-half + 0.1f, half - 0.1f})
      m.Box(kSteel, {x - 0.03f, kBenchTop, -0.03f}, {x + 0.03f, shelf, 0.03f});
    m.Box(kWhitePaint, {-half + 0.04f, shelf, -0.17f}, {half - 0.04f, shelf + 0.03f, 0.17f});
    for (const float x : Spaced(-half + 0.2f, half - 0.15f, 0.22f)) {
      const float z = m.Draw(-0.1f, 0.1f);
      if (m.Chance(0.45)) Glassware(m, {x, shelf + 0.03f, z});
    }
  }
  const bool has_stools = m.Chance(0.75);
  for (const float yaw : {0.0f, 2.0f * kQuarterTurn}) {
    const Frame frame(&m, {0, 0, 0}, yaw);
    Doors(m, body, {-half + 0.05f, half - 0.05f, 0.14f, kBenchTop - 0.06f, kDeep - 0.06f}, doors);
    for (const float x : Spaced(-half + 0.35f, half - 0.3f, 0.6f)) {
      if (m.Chance(0.5)) Apparatus(m, {x, kBenchTop, 0.42f});
    }
    if (!has_stools) continue;
    for (const float x : Spaced(-half + 0.4f, half - 0.3f, 1.0f)) Stool(m, {x, 0, kDeep + 0.14f});
  }
  m.AddTop(kBenchTop, {-half, 0.22f}, {half, kDeep});
}

/// A bench along a wall with a sink, instruments and cupboards below.
void LabWallBench(PieceMaker& m) {
  const float width = m.Width(1.6f, 2.6f);
  const float half = 0.5f * width;
  constexpr float kDeep = 0.7f;
  const Surface& body = m.palette().cabinet;
  m.Box(kDark, {-half + 0.03f, 0, 0}, {half - 0.03f, 0.1f, kDeep - 0.08f});
  Body(m, body, {-half, 0.1f, 0}, {half, kBenchTop - 0.04f, kDeep - 0.04f});
  const float split = m.Draw(-0.2f, 0.4f) * half;
  Doors(m, body, {-half, split, 0.12f, kBenchTop - 0.05f, kDeep - 0.04f}, 2);
  Drawers(m, body, {split, half, 0.12f, kBenchTop - 0.05f, kDeep - 0.04f}, 3);
  m.Box(BenchTop(m), {-half, kBenchTop - 0.04f, 0}, {half, kBenchTop, kDeep});
  const float sink = -half + 0.35f;
  m.Box(kSteel, {sink - 0.22f, kBenchTop, 0.2f}, {sink + 0.22f, kBenchTop + 0.012f, 0.58f});
  m.Box(kDark, {sink - 0.18f, kBenchTop + 0.012f, 0.24f},
        {sink + 0.18f, kBenchTop + 0.016f, 0.54f});
  if (m.Fits(kBenchTop + 0.3f)) {
    const Frame frame(&m, {sink, kBenchTop, 0.1f});
    Tap(m, {0, 0, 0}, 0.26f, 0.2f);
  }
  for (const float x : Spaced(sink + 0.5f, half - 0.25f, 0.48f)) {
    if (m.Fits(kBenchTop + 0.4f) && m.Chance(0.75)) Apparatus(m, {x, kBenchTop, 0.36f});
  }
  m.AddTop(kBenchTop, {sink + 0.3f, 0.1f}, {half, kDeep});
}

/// A cabinet with a sash under which fumes are drawn off.
void FumeHood(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.2f, 1.8f);
  const float high = m.Draw(2.15f, 2.38f);
  constexpr float kDeep = 0.8f;
  const Surface shell = m.Chance(0.7) ? kWhitePaint : Surface{"painted_wood", MutedColor(m)};
  Body(m, shell, {-half, 0, 0}, {half, kBenchTop - 0.05f, kDeep - 0.06f});
  Doors(m, shell, {-half, half, 0.08f, kBenchTop - 0.07f, kDeep - 0.06f}, 2);
  m.Box(BenchTop(m), {-half, kBenchTop - 0.05f, 0}, {half, kBenchTop, kDeep});
  OpenBody(m, shell, {-half, kBenchTop, 0}, {half, 1.8f, kDeep - 0.02f}, 0.06f);
  m.Box(shell, {-half, 1.8f, 0}, {half, high, kDeep - 0.02f});
  const float sash = kBenchTop + m.Draw(0.25f, 0.6f);
  m.Box(kGlass, {-half + 0.06f, sash, kDeep - 0.06f}, {half - 0.06f, 1.8f, kDeep - 0.045f});
  m.Box(kSteel, {-half + 0.06f, sash - 0.03f, kDeep - 0.07f}, {half - 0.06f, sash, kDeep - 0.03f});
  for (const float x : {-0.4f * half, 0.3f * half}) Glassware(m, {x, kBenchTop + 0.06f, 0.4f});
}

constexpr std::array kKinds = {
    FurnitureKind{"fume_hood", Placement::kAgainstWall, 0.7f, FumeHood, 1.1f, 2.0f},
    FurnitureKind{"lab_bench", Placement::kFree, 0.4f, LabBench, 1.4f, 4.2f},
    FurnitureKind{"lab_wall_bench", Placement::kAgainstWall, 0.7f, LabWallBench, 1.2f, 3.6f}};

}  // namespace

std::span<const FurnitureKind> Laboratory() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
