// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr Surface kWarm{"lamp_shade", {255, 244, 220}};

/// Rose on the ceiling and the cord or rod down to -drop.
void Hanger(PieceMaker& m, const Surface& surface, float drop, float radius) {
  m.Cylinder(surface, {0, -0.03f, 0}, 0.06f, 0.03f, 8);
  m.Bar(surface, {0, -drop, 0}, {0, -0.02f, 0}, radius, 4);
}

void LitBall(PieceMaker& m, const Vec& centre, float radius, int sides) {
  m.SetGlow(Glow::kLamp);
  m.Ball(kWarm, centre, {radius, radius, radius}, sides);
  m.SetGlow(Glow::kNone);
}

void PendantLamp(PieceMaker& m) {
  const float drop = m.Draw(0.55f, 0.8f);
  const float radius = m.Draw(0.17f, 0.26f);
  Hanger(m, kBlackPlastic, drop, 0.013f);
  switch (m.Below(4)) {
    case 0:  // a dome of metal, lit from inside
      m.Turn(m.Chance(0.5) ? m.palette().metal : Surface{"painted_wood", MutedColor(m)},
             {0, -drop - 0.16f, 0},
             {{radius, 0.0f}, {0.85f * radius, 0.1f}, {0.45f * radius, 0.18f}, {0.0f, 0.2f}}, 12);
      m.SetGlow(Glow::kLamp);
      m.Turn(kWarm, {0, -drop - 0.15f, 0}, {{0.0f, 0.0f}, {0.97f * radius, 0.0f}}, 12);
      m.SetGlow(Glow::kNone);
      break;
    case 1:
      LitBall(m, {0, -drop - 0.7f * radius, 0}, 0.8f * radius, 12);
      break;
    case 2:
      m.SetGlow(Glow::kLamp);
      m.Cone(m.palette().shade, {0, -drop - 0.2f, 0}, radius, 0.9f * radius, 0.22f, 14);
      m.SetGlow(Glow::kNone);
      break;
    case 3:  // woven
      m.Turn(kWicker, {0, -drop - 0.22f, 0},
             {{0.7f * radius, 0.0f}, {1.1f * radius, 0.07f}, {0.8f * radius, 0.2f}, {0.0f, 0.24f}},
             12);
      LitBall(m, {0, -drop - 0.2f, 0}, 0.06f, 8);
      break;
  }
}

void CeilingLamp(PieceMaker& m) {
  const float radius = m.Draw(0.17f, 0.27f);
  switch (m.Below(3)) {
    case 0:  // a shallow dome
      m.Cylinder(m.palette().metal, {0, -0.03f, 0}, radius, 0.03f, 14);
      m.SetGlow(Glow::kLamp);
      m.Turn(kWarm, {0, -0.12f, 0}, {{0.0f, 0.0f}, {0.6f * radius, 0.02f}, {0.94f * radius, 0.09f}},
             14);
      m.SetGlow(Glow::kNone);
      break;
    case 1:  // a drum of cloth
      m.SetGlow(Glow::kLamp);
      m.Cylinder(m.palette().shade, {0, -0.17f, 0}, radius, 0.15f, 16);
      m.SetGlow(Glow::kNone);
      m.Cylinder(m.palette().metal, {0, -0.02f, 0}, 0.08f, 0.02f, 8);
      break;
    case 2:  // a beam with spots
      m.Box(m.palette().metal, {-0.36f, -0.03f, -0.03f}, {0.36f, 0, 0.03f});
      for (const float x : {-0.28f, 0.0f, 0.28f}) {
        const Frame frame(&m, Turned({x, -0.03f, 0}, 0.0f, 0.3f * (x < 0.0f ? 1.0f : -1.0f)));
        m.Cylinder(m.palette().metal, {0, -0.12f, 0}, 0.05f, 0.12f, 8);
        m.SetGlow(Glow::kLamp);
        m.Turn(kWarm, {0, -0.123f, 0}, {{0.0f, 0.0f}, {0.043f, 0.0f}}, 8);
        m.SetGlow(Glow::kNone);
      }
      break;
  }
}

void Chandelier(PieceMaker& m) {
  const Surface metal = m.Chance(0.6) ? kBrass : kBlackMetal;
  const float drop = m.Draw(0.5f, 0.65f);
  const int arms = m.Between(5, 6);
  const float reach = m.Draw(0.28f, 0.36f);
  Hanger(m, metal, drop, 0.018f);
  m.Turn(metal, {0, -drop - 0.12f, 0},
         {{0.0f, 0.0f}, {0.05f, 0.06f}, {0.02f, 0.12f}, {0.045f, 0.17f}, {0.015f, 0.22f}}, 8);
  for (int i = 0; i < arms; ++i) {
    const Frame frame(&m, {0, -drop, 0},
                      4.0f * kQuarterTurn * static_cast<float>(i) / static_cast<float>(arms));
    m.Bar(metal, {0, -0.04f, 0}, {0, -0.1f, 0.6f * reach}, 0.016f, 3);
    m.Bar(metal, {0, -0.1f, 0.6f * reach}, {0, -0.01f, reach}, 0.016f, 3);
    m.Turn(metal, {0, -0.01f, reach}, {{0.015f, 0.0f}, {0.05f, 0.02f}, {0.0f, 0.02f}}, 5);
    Post(m, kWhitePlastic, {0, 0.01f, reach}, 0.026f, 0.07f);
    LitBall(m, {0, 0.11f, reach}, 0.036f, 5);
  }
}

void FanLamp(PieceMaker& m) {
  const Surface body = m.Chance(0.5) ? m.palette().metal : kWhitePlastic;
  const Surface& blade = m.palette().wood;
  Hanger(m, body, 0.22f, 0.02f);
  m.Turn(body, {0, -0.36f, 0},
         {{0.0f, 0.0f}, {0.11f, 0.01f}, {0.13f, 0.08f}, {0.06f, 0.14f}, {0.0f, 0.14f}}, 10);
  const int blades = m.Between(4, 5);
  for (int i = 0; i < blades; ++i) {
    const Frame frame(&m, Turned({0, -0.3f, 0}, 4.0f * kQuarterTurn * static_cast<float>(i) /
                                                    static_cast<float>(blades)));
    const Frame tilt(&m, Turned({0, 0, 0}, 0.0f, 0.0f, 0.16f));
    m.Box(blade, {-0.065f, 0, 0.13f}, {0.065f, 0.012f, 0.6f});
  }
  LitBall(m, {0, -0.4f, 0}, 0.1f, 10);
}

constexpr std::array kKinds = {
    FurnitureKind{"ceiling_lamp", Placement::kCeiling, 0.0f, CeilingLamp},
    FurnitureKind{"chandelier", Placement::kCeiling, 0.0f, Chandelier},
    FurnitureKind{"fan_lamp", Placement::kCeiling, 0.0f, FanLamp},
    FurnitureKind{"pendant_lamp", Placement::kCeiling, 0.0f, PendantLamp}};

}  // namespace

std::span<const FurnitureKind> CeilingLamps() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
