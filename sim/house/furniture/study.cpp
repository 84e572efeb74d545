// SPDX-License-Identifier: MIT

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kDeskTop = 0.74f;

void Monitor(PieceMaker& m, float x, float yaw) {
  const Frame frame(&m, {x, kDeskTop, 0.2f}, yaw);
  m.Block(kBlackPlastic, {0, 0, 0}, {0.22f, 0.015f, 0.16f});
  m.Block(kBlackPlastic, {0, 0.015f, -0.02f}, {0.04f, 0.16f, 0.03f});
  m.Box(kBlackPlastic, {-0.29f, 0.12f, 0}, {0.29f, 0.48f, 0.03f});
  Sheet(m, {"computer_screen"}, {0, 0.135f, 0.033f}, 0.55f, 0.33f);
}

void DeskClutter(PieceMaker& m, float half, float depth) {
  const int monitors = half > 0.62f && m.Chance(0.4) ? 2 : 1;
  if (monitors == 2) {
    Monitor(m, -0.31f, 0.2f);
    Monitor(m, 0.31f, -0.2f);
  } else {
    Monitor(m, m.Draw(-0.15f, 0.15f), 0.0f);
  }
  m.Box(kBlackPlastic, {-0.22f, kDeskTop, depth - 0.24f},
        {0.22f, kDeskTop + 0.018f, depth - 0.09f});
  const float y = kDeskTop + 0.02f;
  m.Picture({"keyboard"}, {-0.215f, y, depth - 0.095f}, {0.215f, y, depth - 0.095f},
            {0.215f, y, depth - 0.235f}, {-0.215f, y, depth - 0.235f});
  m.Block(kBlackPlastic, {0.32f, kDeskTop, depth - 0.17f}, {0.06f, 0.03f, 0.1f});
  const float side = half - 0.14f;
  if (m.Chance(0.6)) {  // a lamp with a bent arm
    const Surface& metal = m.palette().metal;
    m.Cylinder(metal, {-side, kDeskTop, 0.15f}, 0.08f, 0.02f, 8);
    const Vec elbow(-side, kDeskTop + 0.36f, 0.08f);
    m.Bar(metal, {-side, kDeskTop, 0.15f}, elbow, 0.012f, 4);
    const Vec head(-side + 0.12f, kDeskTop + 0.42f, 0.28f);
    m.Bar(metal, elbow, head, 0.012f, 4);
    m.SetGlow(Glow::kLamp);
    m.Cone(m.palette().shade, head - Vec(0, 0.1f, 0), 0.085f, 0.035f, 0.11f, 8);
    m.SetGlow(Glow::kNone);
  }
  if (m.Chance(0.6))
    Books(m, {side - 0.2f, kDeskTop, 0.05f}, {side + 0.1f, kDeskTop + 0.3f, 0.26f});
  if (m.Chance(0.5)) {  // papers
    const float x = -0.62f * side;
    m.Box(kPaper, {x - 0.1f, kDeskTop, depth - 0.35f},
          {x + 0.1f, kDeskTop + 0.012f, depth - 0.06f});
  }
}

void Desk(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.15f, 1.65f);
  const float depth = m.Draw(0.6f, 0.72f);
  const Surface& wood = m.palette().wood;
  m.Box(wood, {-half, kDeskTop - 0.03f, 0}, {half, kDeskTop, depth});
  const float under = kDeskTop - 0.03f;
  const int style = m.Below(3);
  const Surface& body = m.Chance(0.5) ? m.palette().cabinet : wood;
  if (style == 0) {
    const bool is_metal = m.Chance(0.5);
    Legs(m, is_metal ? m.palette().metal : wood,
         {is_metal ? LegStyle::kSquare : LegStyle::kTapered,
          {-half + 0.02f, 0.02f},
          {half - 0.02f, depth - 0.02f},
          under,
          0.05f});
  } else {
    const float drawers = half - 0.42f;  // where the pedestal begins
    Body(m, body, {drawers, 0, 0.03f}, {half - 0.02f, under, depth - 0.03f});
    Drawers(m, body, {drawers, half - 0.02f, 0.05f, under, depth - 0.03f}, 3);
    if (style == 1) {
      m.Box(body, {-half + 0.02f, 0, 0.03f}, {-half + 0.05f, under, depth - 0.03f});
    } else {
      Body(m, body, {-half + 0.02f, 0, 0.03f}, {-half + 0.38f, under, depth - 0.03f});
      Doors(m, body, {-half + 0.02f, -half + 0.38f, 0.05f, under, depth - 0.03f}, 1,
            HandleAt::kTop);
    }
    m.Box(body, {-half + 0.05f, 0.3f, 0.04f}, {drawers, under, 0.06f});
  }
  DeskClutter(m, half, depth);
}

/// Five spokes with castors and a gas spring.
void SwivelBase(PieceMaker& m, const Surface& metal, float seat) {
  for (int i = 0; i < 5; ++i) {
    const float angle = 0.8f * kQuarterTurn * static_cast<float>(i);
    const Vec foot(0.29f * Sin(angle), 0.05f, 0.29f * Cos(angle));
    const Frame frame(&m, {0, 0, 0}, angle);
    m.TaperedBox(metal, {0, 0.06f, 0.16f}, {0.045f, 0.27f}, {0, 0.1f, 0.14f}, {0.04f, 0.25f});
    m.Box(kDark, {-0.022f, 0, 0.265f}, {0.022f, 0.06f, 0.315f});
  }
  m.Cylinder(metal, {0, 0.06f, 0}, 0.03f, seat - 0.12f, 6);
}

void OfficeChair(PieceMaker& m) {
  const Surface frame_surface = m.Chance(0.6) ? kBlackPlastic : kWhitePlastic;
  const Surface cloth = m.Chance(0.5) ? Surface{"canvas", {52, 52, 56}}
                                      : (m.Chance(0.5) ? m.palette().accent : m.palette().fabric);
  const float seat = m.Draw(0.46f, 0.52f);
  const bool is_high = m.Chance(0.4);
  SwivelBase(m, m.Chance(0.5) ? kChrome : kBlackPlastic, seat);
  m.Block(frame_surface, {0, seat - 0.08f, 0}, {0.3f, 0.03f, 0.3f});
  m.RoundedBox(cloth, {-0.25f, seat - 0.06f, -0.22f}, {0.25f, seat + 0.02f, 0.26f}, 0.04f);
  {
    const Frame frame(&m, Turned({0, seat + 0.06f, -0.24f}, 0.0f, -0.12f));
    m.Box(frame_surface, {-0.03f, -0.16f, -0.04f}, {0.03f, 0.2f, -0.01f});
    m.RoundedBox(cloth, {-0.23f, 0.04f, -0.02f}, {0.23f, is_high ? 0.72f : 0.52f, 0.05f}, 0.04f);
  }
  for (const float x : {-0.29f, 0.29f}) {
    m.Box(frame_surface, {x - 0.015f, seat - 0.06f, -0.06f}, {x + 0.015f, seat + 0.2f, -0.02f});
    m.Box(frame_surface, {x - 0.03f, seat + 0.2f, -0.16f}, {x + 0.03f, seat + 0.23f, 0.13f});
  }
}

void FilingCabinet(PieceMaker& m) {
  const std::array<Surface, 3> surfaces = {Surface{"painted_wood", {150, 154, 158}}, kWhitePaint,
                                           Surface{"painted_wood", {70, 86, 92}}};
  const Surface surface = m.rng().Pick(surfaces);
  const float half = 0.5f * m.Draw(0.42f, 0.5f);
  const int rows = m.Between(2, 4);
  const float height = 0.06f + 0.31f * static_cast<float>(rows);
  constexpr float kDepth = 0.56f;
  Body(m, surface, {-half, 0, 0}, {half, height, kDepth});
  for (int i = 0; i < rows; ++i) {
    const float y = 0.04f + 0.31f * static_cast<float>(i);
    m.Box(surface, {-half + 0.012f, y, kDepth}, {half - 0.012f, y + 0.295f, kDepth + 0.015f});
    const Vec middle(0, y + 0.2f, kDepth + 0.015f);
    Panel(m, kSteel, middle - Vec(0.07f, 0.015f, 0), middle + Vec(0.07f, 0.01f, 0.03f));
    Sheet(m, kPaper, middle + Vec(0, 0.03f, 0.003f), 0.11f, 0.045f);
  }
  m.AddTop(height, {-half, 0.0f}, {half, kDepth});
}

constexpr std::array kKinds = {
    FurnitureKind{"desk", Placement::kAgainstWall, 0.9f, Desk, 0.9f, 2.0f},
    FurnitureKind{"filing_cabinet", Placement::kAgainstWall, 0.6f, FilingCabinet},
    FurnitureKind{"office_chair", Placement::kFree, 0.2f, OfficeChair}};

}  // namespace

std::span<const FurnitureKind> Study() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
