// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

using Oval = MeshBuilder::Oval;

constexpr Surface kWater{"glass", {190, 215, 222}};

/// The lid upright behind the seat, or lying on it.
void ToiletLid(PieceMaker& m, const Surface& white) {
  if (m.Chance(0.6)) {
    m.Loft(
        white,
        std::array{Oval{{0, 0.42f, 0.44f}, {0.19f, 0.25f}}, Oval{{0, 0.45f, 0.44f}, {0.19f, 0.25f}},
                   Oval{{0, 0.455f, 0.44f}, {0.0f, 0.0f}}},
        12);
    return;
  }
  // The seat with its hole, and the lid against the tank.
  m.Loft(
      white,
      std::array{Oval{{0, 0.41f, 0.44f}, {0.19f, 0.25f}}, Oval{{0, 0.435f, 0.44f}, {0.19f, 0.25f}},
                 Oval{{0, 0.435f, 0.45f}, {0.12f, 0.17f}}, Oval{{0, 0.3f, 0.44f}, {0.08f, 0.11f}}},
      12);
  m.Loft(kWater,
         std::array{Oval{{0, 0.3f, 0.44f}, {0.08f, 0.11f}}, Oval{{0, 0.3f, 0.44f}, {0.0f, 0.0f}}},
         12);
  const Frame frame(&m, Turned({0, 0.66f, 0.2f}, 0.0f, kQuarterTurn - 0.1f));
  m.Loft(white,
         std::array{Oval{{0, 0, 0}, {0.0f, 0.0f}}, Oval{{0, 0, 0}, {0.18f, 0.23f}},
                    Oval{{0, 0.02f, 0}, {0.18f, 0.23f}}, Oval{{0, 0.025f, 0}, {0.0f, 0.0f}}},
         12);
}

void Toilet(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.04f));
  const Surface& white = m.palette().ceramic;
  const bool is_hung = m.Chance(0.3);  // on a boxed-in frame instead of standing with its tank
  if (is_hung) {
    m.Box(kWhitePaint, {-0.3f, 0, 0}, {0.3f, 1.0f, 0.17f});
    m.Box(kSteel, {-0.12f, 0.82f, 0.17f}, {0.12f, 0.94f, 0.18f});
    m.Loft(white,
           std::array{
               Oval{{0, 0.12f, 0.34f}, {0.0f, 0.0f}}, Oval{{0, 0.14f, 0.34f}, {0.11f, 0.17f}},
               Oval{{0, 0.36f, 0.43f}, {0.18f, 0.25f}}, Oval{{0, 0.42f, 0.43f}, {0.18f, 0.25f}}},
           12);
  } else {
    m.RoundedBox(white, {-0.2f, 0.38f, 0}, {0.2f, 0.76f, 0.17f}, 0.03f);
    m.Box(white, {-0.21f, 0.76f, 0}, {0.21f, 0.795f, 0.18f});
    m.Cylinder(kChrome, {0, 0.795f, 0.09f}, 0.025f, 0.012f, 8);
    m.Box(white, {-0.1f, 0.0f, 0.06f}, {0.1f, 0.38f, 0.25f});
    m.Loft(white,
           std::array{
               Oval{{0, 0.0f, 0.38f}, {0.12f, 0.21f}}, Oval{{0, 0.16f, 0.36f}, {0.1f, 0.18f}},
               Oval{{0, 0.36f, 0.43f}, {0.18f, 0.25f}}, Oval{{0, 0.42f, 0.43f}, {0.18f, 0.25f}}},
           12);
  }
  m.Box(white, {-0.15f, 0.36f, 0.12f}, {0.15f, 0.43f, 0.3f});
  ToiletLid(m, white);
}

/// Mirror over a basin with a lamp on top.
void BasinMirror(PieceMaker& m, float half) {
  if (!m.Fits(1.85f)) return;
  if (m.Chance(0.3)) {
    const Frame frame(&m, Turned({0, 1.5f, 0.0f}, 0.0f, kQuarterTurn));
    const float radius = std::min(half, 0.36f);
    m.Cylinder(m.palette().metal, {0, 0, 0}, radius, 0.025f, 18);
    PictureDisc(m, kMirror, {0, 0.028f, 0}, radius - 0.025f, 18);
  } else {
    m.Box(m.Chance(0.5) ? m.palette().metal : m.palette().wood, {-half, 1.1f, 0},
          {half, 1.8f, 0.025f});
    Sheet(m, kMirror, {0, 1.125f, 0.028f}, 2.0f * half - 0.05f, 0.65f);
  }
  m.Box(kChrome, {-0.2f, 1.84f, 0}, {0.2f, 1.87f, 0.05f});
  m.SetGlow(Glow::kLamp);
  m.Box({"lamp_shade"}, {-0.24f, 1.83f, 0.05f}, {0.24f, 1.89f, 0.1f});
  m.SetGlow(Glow::kNone);
}

void Washbasin(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.6f, 1.3f, 0.02f);
  const Surface& cabinet = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
  const float foot = m.Chance(0.5) ? 0.28f : 0.08f;  // hung on the wall, or on legs
  constexpr float kDepth = 0.46f;
  constexpr float kTop = 0.85f;
  if (foot < 0.2f)
    Legs(m, m.palette().metal, {LegStyle::kSquare, {-half, 0}, {half, kDepth}, foot, 0.04f});
  Body(m, cabinet, {-half, foot, 0}, {half, kTop - 0.13f, kDepth - 0.02f});
  const FrontField front = {-half, half, foot, kTop - 0.13f, kDepth - 0.02f};
  const bool is_double = half > 0.55f;
  if (m.Chance(0.5)) {
    Doors(m, cabinet, front, is_double ? 4 : 2, HandleAt::kTop);
  } else {
    Drawers(m, cabinet, front, 2);
  }
  // The basin's slab around its hollow.
  const Surface& white = m.palette().ceramic;
  const float hole = is_double ? half - 0.12f : half - 0.09f;
  constexpr float kLow = kTop - 0.13f;
  m.Box(white, {-half - 0.01f, kLow, 0}, {-hole, kTop, kDepth});
  m.Box(white, {hole, kLow, 0}, {half + 0.01f, kTop, kDepth});
  m.Box(white, {-hole, kLow, 0}, {hole, kTop, 0.12f});
  m.Box(white, {-hole, kLow, kDepth - 0.05f}, {hole, kTop, kDepth});
  Hollow(m, Shaded(white, 0.9f), {-hole, kTop - 0.12f, 0.12f}, {hole, kTop, kDepth - 0.05f}, 0.05f);
  if (is_double) {
    Tap(m, {-0.5f * half, kTop, 0.07f}, 0.16f, 0.13f);
    Tap(m, {0.5f * half, kTop, 0.07f}, 0.16f, 0.13f);
  } else {
    Tap(m, {0, kTop, 0.07f}, 0.16f, 0.13f);
  }
  BasinMirror(m, half - 0.02f);
  m.Cylinder({"plastic", BrightColor(m)}, {half - 0.06f, kTop, 0.1f}, 0.03f, 0.13f, 6);
}

void PedestalBasin(PieceMaker& m) {
  const Surface& white = m.palette().ceramic;
  constexpr float kTop = 0.84f;
  m.Turn(white, {0, 0, 0.2f}, {{0.13f, 0.0f}, {0.085f, 0.12f}, {0.09f, 0.68f}}, 8);
  m.Loft(white,
         std::array{Oval{{0, 0.62f, 0.22f}, {0.1f, 0.1f}},
                    Oval{{0, kTop - 0.07f, 0.25f}, {0.29f, 0.225f}},
                    Oval{{0, kTop, 0.25f}, {0.3f, 0.235f}}, Oval{{0, kTop, 0.27f}, {0.24f, 0.16f}},
                    Oval{{0, kTop - 0.12f, 0.26f}, {0.14f, 0.09f}},
                    Oval{{0, kTop - 0.13f, 0.26f}, {0.0f, 0.0f}}},
         14);
  m.Box(white, {-0.26f, kTop - 0.1f, 0}, {0.26f, kTop + 0.02f, 0.12f});
  Tap(m, {0, kTop + 0.02f, 0.07f}, 0.12f, 0.13f);
  BasinMirror(m, m.Draw(0.22f, 0.3f));
}

/// Shower on the wall z = 0 at x: a riser with its head, and the mixer.
void WallShower(PieceMaker& m, float x, float mixer) {
  m.Box(kChrome, {x - 0.12f, mixer, 0}, {x + 0.12f, mixer + 0.045f, 0.06f});
  m.Bar(kChrome, {x, mixer, 0.045f}, {x, 2.02f, 0.045f}, 0.012f, 4);
  m.Bar(kChrome, {x, 2.02f, 0.045f}, {x, 2.0f, 0.28f}, 0.012f, 4);
  m.Cone(kChrome, {x, 1.95f, 0.28f}, 0.11f, 0.03f, 0.04f, 10);
}

/// A rod around the tub with a gathered curtain.
void TubCurtain(PieceMaker& m, float half, float depth) {
  constexpr float kRod = 1.98f;
  for (const float x : {-half + 0.02f, half - 0.02f}) {
    m.Bar(kChrome, {x, kRod, 0}, {x, kRod, depth}, 0.012f, 4);
  }
  m.Bar(kChrome, {-half, kRod, depth}, {half, kRod, depth}, 0.012f, 4);
  const float x = half - m.Draw(0.55f, 0.8f);
  m.Drape(m.palette().accent, {x, kRod - 0.02f, depth}, {half - 0.03f, kRod - 0.02f, depth}, 1.6f,
          0.06f, 6);
}

void BuiltInTub(PieceMaker& m, float half, float depth, float top) {
  const Surface& white = m.palette().ceramic;
  const Surface panel = m.Chance(0.4) ? m.palette().backsplash : white;
  constexpr float kRim = 0.08f;
  const float low = top - 0.04f;
  const float front = depth - 0.01f;
  m.Quad(panel, {-half, 0, front}, {half, 0, front}, {half, low, front}, {-half, low, front});
  m.Quad(panel, {half, 0, front}, {half, 0, 0}, {half, low, 0}, {half, low, front});
  m.Quad(panel, {-half, 0, 0}, {-half, 0, front}, {-half, low, front}, {-half, low, 0});
  m.Box(white, {-half, low, 0}, {half, top, kRim});
  m.Box(white, {-half, low, depth - kRim}, {half, top, depth});
  m.Box(white, {-half, low, kRim}, {-half + 0.14f, top, depth - kRim});
  m.Box(white, {half - kRim, low, kRim}, {half, top, depth - kRim});
  Hollow(m, Shaded(white, 0.9f), {-half + 0.14f, 0.16f, kRim}, {half - kRim, top, depth - kRim},
         0.1f);
}

void FreeTub(PieceMaker& m, float half, float depth, float top) {
  const Surface outside =
      m.Chance(0.4) ? Surface{"white_enamel", MutedColor(m)} : m.palette().ceramic;
  const Surface& white = m.palette().ceramic;
  const float z = 0.5f * depth;
  m.Loft(
      outside,
      std::array{Oval{{0, 0.08f, z}, {0.7f * half, 0.6f * z}},
                 Oval{{0, 0.5f * top, z}, {0.92f * half, 0.92f * z}}, Oval{{0, top, z}, {half, z}}},
      18);
  m.Loft(
      white,
      std::array{Oval{{0, top, z}, {half, z}}, Oval{{0, top + 0.02f, z}, {half - 0.02f, z - 0.02f}},
                 Oval{{0, top, z}, {half - 0.06f, z - 0.06f}},
                 Oval{{0, 0.2f, z}, {0.72f * half, 0.6f * z}}, Oval{{0, 0.18f, z}, {0.0f, 0.0f}}},
      18);
  Legs(m, m.palette().metal,
       {LegStyle::kSquare,
        {-0.6f * half, 0.25f * depth},
        {0.6f * half, 0.75f * depth},
        0.2f,
        0.07f});
}

void Bathtub(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.55f, 1.8f);
  const float depth = m.Draw(0.72f, 0.82f);
  const float top = m.Draw(0.54f, 0.62f);
  const bool is_free = m.Chance(0.35);
  if (is_free) {
    FreeTub(m, half, depth, top);
    m.Bar(kChrome, {0.55f * half, 0.0f, 0.02f}, {0.55f * half, top + 0.2f, 0.02f}, 0.018f, 5);
    m.Bar(kChrome, {0.55f * half, top + 0.2f, 0.02f}, {0.55f * half, top + 0.17f, 0.2f}, 0.016f, 5);
    return;
  }
  BuiltInTub(m, half, depth, top);
  const bool has_shower = m.Fits(2.05f) && m.Chance(0.6);
  if (has_shower) {
    WallShower(m, -half + 0.35f, top + 0.3f);
    if (m.Chance(0.6)) TubCurtain(m, half, depth + 0.04f);
  } else {
    m.Box(kChrome, {-half + 0.25f, top + 0.08f, 0}, {-half + 0.45f, top + 0.13f, 0.06f});
    m.Bar(kChrome, {-half + 0.35f, top + 0.1f, 0.05f}, {-half + 0.35f, top + 0.07f, 0.2f}, 0.016f,
          5);
  }
}

/// Tray, tiled walls behind, fittings, posts with rails, and a pane where one does not look in.
void ShowerCabin(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.82f, 1.05f);
  const float depth = m.Draw(0.82f, 1.0f);
  constexpr float kTop = 2.0f;
  const Surface& white = m.palette().ceramic;
  const Surface& tile = m.palette().backsplash;
  m.Box(white, {-half, 0, 0}, {half, 0.12f, depth});
  m.Quad(Shaded(white, 0.86f), {-half + 0.06f, 0.122f, depth - 0.06f},
         {half - 0.06f, 0.122f, depth - 0.06f}, {half - 0.06f, 0.122f, 0.06f},
         {-half + 0.06f, 0.122f, 0.06f});
  Panel(m, tile, {-half, 0.12f, 0}, {half, kTop + 0.1f, 0.015f});
  m.Box(tile, {-half, 0.12f, 0.015f}, {-half + 0.015f, kTop + 0.1f, depth});
  WallShower(m, 0.1f, 1.05f);
  const Surface& metal = m.palette().metal;
  for (const Vec2& p : {Vec2(half - 0.02f, 0.03f), Vec2(half - 0.02f, depth - 0.02f),
                        Vec2(-half + 0.03f, depth - 0.02f)}) {
    Post(m, metal, {p.x(), 0.12f, p.y()}, 0.035f, kTop - 0.12f);
  }
  m.Box(metal, {-half, kTop - 0.04f, depth - 0.035f}, {half, kTop, depth - 0.005f});
  m.Box(metal, {half - 0.035f, kTop - 0.04f, 0}, {half - 0.005f, kTop, depth});
  if (m.Chance(0.3)) {
    m.Drape(m.palette().accent, {-half + 0.05f, kTop - 0.05f, depth - 0.03f},
            {-0.25f * half, kTop - 0.05f, depth - 0.03f}, kTop - 0.25f, 0.06f, 5);
    return;
  }
  m.Box(kGlass, {half - 0.025f, 0.14f, 0.04f}, {half - 0.017f, kTop - 0.04f, depth - 0.04f});
  m.Box(kGlass, {0.0f, 0.14f, depth - 0.025f}, {half - 0.03f, kTop - 0.04f, depth - 0.017f});
  Post(m, metal, {0.0f, 0.14f, depth - 0.02f}, 0.025f, kTop - 0.18f);
}

constexpr std::array kKinds = {
    FurnitureKind{"bathtub", Placement::kAgainstWall, 0.6f, Bathtub, 1.4f, 1.9f},
    FurnitureKind{"pedestal_basin", Placement::kAgainstWall, 0.6f, PedestalBasin},
    FurnitureKind{"shower_cabin", Placement::kCorner, 0.6f, ShowerCabin},
    FurnitureKind{"toilet", Placement::kAgainstWall, 0.6f, Toilet},
    FurnitureKind{"washbasin", Placement::kAgainstWall, 0.7f, Washbasin, 0.5f, 1.6f}};

}  // namespace

std::span<const FurnitureKind> Bathroom() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
