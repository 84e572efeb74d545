// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

Surface Towel(PieceMaker& m) {
  const std::array<Surface, 3> colors = {m.palette().accent, m.palette().other_accent,
                                         Surface{"linen", {248, 246, 240}}};
  return {"terry_towel", m.rng().Pick(colors).tint};
}

/// A towel folded over a rod along x at `at`.
void HangingTowel(PieceMaker& m, const Vec& at, float width, float drop) {
  m.Box(Towel(m), at + Vec(-0.5f * width, -drop, -0.03f), at + Vec(0.5f * width, 0.02f, 0.04f));
}

void TowelRail(PieceMaker& m) {
  if (m.Chance(0.5)) {  // one bar
    const float half = m.Draw(0.25f, 0.35f);
    const Vec rod(0, 0.6f, 0.07f);
    for (const float x : {-half, half}) {
      m.Box(m.palette().metal, {x - 0.015f, 0.58f, 0}, {x + 0.015f, 0.62f, 0.08f});
    }
    m.Bar(m.palette().metal, rod - Vec(half, 0, 0), rod + Vec(half, 0, 0), 0.012f, 5);
    HangingTowel(m, rod - Vec(0.45f * half, 0, 0), 0.8f * half, 0.6f);
    if (m.Chance(0.6)) HangingTowel(m, rod + Vec(0.5f * half, 0, 0), 0.7f * half, 0.42f);
    return;
  }
  // A ladder that warms the towels.
  const Surface surface = m.Chance(0.5) ? kChrome : kWhiteEnamel;
  const float height = m.Draw(0.9f, 1.3f);
  for (const float x : {-0.24f, 0.24f}) Post(m, surface, {x, 0, 0.05f}, 0.035f, height);
  for (const float y : Spaced(0.06f, height - 0.04f, 0.11f)) {
    Panel(m, surface, {-0.24f, y, 0.045f}, {0.24f, y + 0.035f, 0.07f});
  }
  HangingTowel(m, {0.0f, height - 0.12f, 0.06f}, 0.4f, 0.45f);
}

void FoldedTowels(PieceMaker& m, float half, float y, float depth) {
  for (int i = 0; i < 3; ++i) {
    const float low = y + 0.055f * static_cast<float>(i);
    Cushion(m, Towel(m), {-half, low, 0.05f}, {half, low + 0.053f, depth}, 0.012f);
  }
}

void ToiletBottles(PieceMaker& m, float half, float y) {
  for (const float x : Spaced(-half, half, 0.09f)) {
    const Surface plastic{"plastic", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
    m.Cylinder(plastic, {x, y, 0.18f}, 0.03f, m.Draw(0.1f, 0.2f), 6);
  }
}

void BathroomShelf(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.34f, 0.5f);
  const float top = m.Draw(1.4f, 1.8f);
  constexpr float kDepth = 0.3f;
  constexpr float kBoard = 0.025f;
  const Surface& surface = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
  OpenBody(m, surface, {-half, 0, 0}, {half, top, kDepth}, kBoard);
  constexpr int kRows = 5;
  const float pitch = (top - kBoard) / static_cast<float>(kRows);
  for (int r = 0; r < kRows; ++r) {
    const float y = pitch * static_cast<float>(r);
    const float inner = half - kBoard;
    if (r > 0) m.Box(surface, {-inner, y, 0.02f}, {inner, y + kBoard, kDepth - 0.01f});
    if (r % 2 == 0) {
      FoldedTowels(m, 0.75f * half, y + kBoard, kDepth - 0.03f);
    } else {
      ToiletBottles(m, half - 0.065f, y + kBoard);
    }
  }
}

void MirrorCabinet(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.5f, 0.9f);
  constexpr float kDepth = 0.14f;
  m.Box(m.palette().cabinet, {-half, 0, 0}, {half, 0.65f, kDepth});
  const int doors = half > 0.33f ? 3 : 2;
  const float width = 2.0f * half / static_cast<float>(doors);
  for (int i = 0; i < doors; ++i) {
    const float x = -half + width * (static_cast<float>(i) + 0.5f);
    Sheet(m, kMirror, {x, 0.008f, kDepth + 0.006f}, width - 0.016f, 0.634f);
  }
  m.SetGlow(Glow::kLamp);
  m.Box({"lamp_shade"}, {-0.7f * half, 0.66f, 0.05f}, {0.7f * half, 0.7f, kDepth});
  m.SetGlow(Glow::kNone);
}

void ToiletPaper(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.06f));
  const Surface& metal = m.palette().metal;
  m.Box(metal, {-0.085f, 0.06f, 0}, {-0.07f, 0.1f, 0.09f});
  m.Box(metal, {0.07f, 0.06f, 0}, {0.085f, 0.1f, 0.09f});
  m.Bar(kPaper, {-0.065f, 0.08f, 0.075f}, {0.065f, 0.08f, 0.075f}, 0.06f, 10);
  m.Box(kPaper, {-0.06f, 0.0f, 0.128f}, {0.06f, 0.08f, 0.134f});
}

void SoapSet(PieceMaker& m) {
  const Surface bottle{"plastic", m.Chance(0.5) ? MutedColor(m) : BrightColor(m)};
  m.Turn(bottle, {-0.06f, 0, 0},
         {{0.035f, 0.0f}, {0.038f, 0.11f}, {0.012f, 0.13f}, {0.012f, 0.16f}, {0.0f, 0.16f}}, 8);
  m.Box(kChrome, {-0.065f, 0.16f, -0.01f}, {-0.055f, 0.175f, 0.05f});
  m.Turn(m.palette().ceramic, {0.05f, 0, 0},
         {{0.035f, 0.0f}, {0.04f, 0.1f}, {0.034f, 0.1f}, {0.03f, 0.02f}}, 8);
  for (const float lean : {-0.25f, 0.2f}) {
    const Frame frame(&m, Turned({0.05f, 0.03f, 0}, 0.0f, 0.0f, lean));
    m.Block({"plastic", BrightColor(m)}, {0, 0, 0.01f * lean}, {0.012f, 0.15f, 0.012f});
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"bathroom_shelf", Placement::kAgainstWall, 0.5f, BathroomShelf},
    FurnitureKind{"mirror_cabinet", Placement::kOnWall, 0.0f, MirrorCabinet},
    FurnitureKind{"soap_set", Placement::kOnTop, 0.0f, SoapSet},
    FurnitureKind{"toilet_paper", Placement::kOnWall, 0.0f, ToiletPaper},
    FurnitureKind{"towel_rail", Placement::kOnWall, 0.3f, TowelRail}};

}  // namespace

std::span<const FurnitureKind> BathroomFittings() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
