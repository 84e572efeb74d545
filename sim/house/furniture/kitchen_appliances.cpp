// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/kitchen_parts.h"

namespace bulletnav::sim::furniture {

void MicrowaveOven(PieceMaker& m, const Vec& at) {
  const Surface& body = m.palette().appliance;
  const Frame frame(&m, at);
  m.Box(body, {-0.25f, 0.01f, 0}, {0.25f, 0.3f, 0.36f});
  m.Quad(kDark, {-0.235f, 0.03f, 0.363f}, {0.11f, 0.03f, 0.363f}, {0.11f, 0.28f, 0.363f},
         {-0.235f, 0.28f, 0.363f});
  Panel(m, kSteel, {0.115f, 0.04f, 0.362f}, {0.14f, 0.27f, 0.395f});
  m.Quad(kBlackPlastic, {0.155f, 0.2f, 0.363f}, {0.235f, 0.2f, 0.363f}, {0.235f, 0.27f, 0.363f},
         {0.155f, 0.27f, 0.363f});
  for (const float y : {0.07f, 0.14f}) {
    Panel(m, kGreyPlastic, {0.17f, y, 0.362f}, {0.22f, y + 0.04f, 0.38f});
  }
}

namespace {

constexpr float kHalf = 0.3f;  // of appliances 0.6 m wide

/// Round knob on a front.
void Knob(PieceMaker& m, const Surface& surface, const Vec& at, float radius) {
  const Frame frame(&m, Turned(at, 0.0f, kQuarterTurn));
  m.Cylinder(surface, {0, 0, 0}, radius, 0.03f, 8);
}

constexpr float kHobTop = kWorktop + 0.012f;

void GlassHob(PieceMaker& m) {
  for (const float x : {-0.14f, 0.14f}) {
    for (const float z : {0.18f, 0.43f}) {
      const float radius = (x < 0.0f) == (z < 0.3f) ? 0.1f : 0.08f;
      Disc(m, {"plastic", {120, 72, 66}}, {x, kHobTop + 0.002f, z}, radius, 12);
      Disc(m, {"plastic", {40, 38, 38}}, {x, kHobTop + 0.004f, z}, 0.82f * radius, 12);
    }
  }
}

/// Burners under grates of iron.
void GasHob(PieceMaker& m) {
  const Surface iron{"cast_iron"};
  constexpr float kLow = kHobTop + 0.015f;
  constexpr float kHigh = kHobTop + 0.03f;
  for (const float x : {-0.14f, 0.14f}) {
    for (const float z : {0.18f, 0.43f}) m.Cylinder(iron, {x, kHobTop, z}, 0.05f, 0.015f, 8);
    for (const float z : {0.18f, 0.3f, 0.43f}) {
      m.Box(iron, {x - 0.12f, kLow, z - 0.008f}, {x + 0.12f, kHigh, z + 0.008f});
    }
    m.Box(iron, {x - 0.008f, kLow, 0.08f}, {x + 0.008f, kHigh, 0.53f});
  }
}

void Hob(PieceMaker& m) {
  const bool is_gas = m.Chance(0.45);
  const Surface plate = is_gas ? kSteel : kDark;
  m.Box(plate, {-kHalf + 0.02f, kWorktop, 0.06f}, {kHalf - 0.02f, kHobTop, 0.56f});
  if (is_gas) {
    GasHob(m);
  } else {
    GlassHob(m);
  }
  if (!m.Chance(0.6)) return;
  CookingPot(m, {m.Chance(0.5) ? -0.14f : 0.14f, kHobTop + 0.03f, 0.18f}, 0.11f, 0.13f);
}

void Hood(PieceMaker& m) {
  const Surface& metal = m.palette().appliance;
  constexpr float kLow = 1.55f;
  if (m.Chance(0.6)) {
    m.Box(metal, {-kHalf, kLow, 0}, {kHalf, kLow + 0.06f, 0.48f});
    m.TaperedBox(metal, {0, kLow + 0.06f, 0.24f}, {0.6f, 0.48f}, {0, kLow + 0.32f, 0.13f},
                 {0.26f, 0.26f});
    m.Box(metal, {-0.13f, kLow + 0.32f, 0}, {0.13f, 2.3f, 0.26f});
  } else {  // under a cabinet
    m.Box(metal, {-kHalf, kLow + 0.03f, 0}, {kHalf, kLow + 0.13f, 0.46f});
    WallUnits(m, {-kHalf, kHalf}, kLow + 0.13f);
  }
  m.SetGlow(Glow::kLamp);
  m.Quad({"lamp_shade"}, {-0.12f, kLow - 0.002f, 0.2f}, {0.12f, kLow - 0.002f, 0.2f},
         {0.12f, kLow - 0.002f, 0.3f}, {-0.12f, kLow - 0.002f, 0.3f});
  m.SetGlow(Glow::kNone);
}

void Stove(PieceMaker& m) {
  const Surface& body = m.palette().appliance;
  constexpr float kFront = 0.59f;
  m.Box(kDark, {-kHalf + 0.02f, 0, 0}, {kHalf - 0.02f, 0.08f, 0.52f});
  m.Box(body, {-kHalf + 0.003f, 0.08f, 0}, {kHalf - 0.003f, kWorktop, kFront});
  m.Quad(kDark, {-kHalf + 0.03f, 0.1f, kFront + 0.002f}, {kHalf - 0.03f, 0.1f, kFront + 0.002f},
         {kHalf - 0.03f, 0.76f, kFront + 0.002f}, {-kHalf + 0.03f, 0.76f, kFront + 0.002f});
  m.Box(body, {-kHalf + 0.02f, 0.24f, kFront}, {kHalf - 0.02f, 0.75f, kFront + 0.02f});
  Sheet(m, {"oven_front"}, {0, 0.3f, kFront + 0.023f}, 0.46f, 0.34f);
  m.Box(body, {-kHalf + 0.02f, 0.1f, kFront}, {kHalf - 0.02f, 0.22f, kFront + 0.02f});
  m.Box(kSteel, {-0.23f, 0.685f, kFront + 0.03f}, {0.23f, 0.71f, kFront + 0.055f});
  for (int i = 0; i < 5; ++i) {
    Knob(m, i == 2 ? kSteel : kBlackPlastic, {-0.2f + 0.1f * static_cast<float>(i), 0.82f, kFront},
         0.024f);
  }
  Hob(m);
  if (m.Fits(2.3f)) {
    Backsplash(m, {-kHalf, kHalf}, 1.56f);
    Hood(m);
  }
}

void FridgeDoor(PieceMaker& m, const Surface& surface, const FrontField& f, bool handle_left) {
  m.RoundedBox(surface, {f.x0 + 0.006f, f.y0 + 0.008f, f.z},
               {f.x1 - 0.006f, f.y1 - 0.008f, f.z + 0.05f}, 0.012f);
  const float x = handle_left ? f.x0 + 0.05f : f.x1 - 0.05f;
  const float length = std::min(0.5f, 0.55f * (f.y1 - f.y0));
  const bool is_upper = f.y0 > 0.5f;
  const float y0 = is_upper ? f.y0 + 0.06f : f.y1 - 0.06f - length;
  Panel(m, kSteel, {x - 0.015f, y0, f.z + 0.05f}, {x + 0.015f, y0 + length, f.z + 0.1f});
}

/// Its doors side by side, one with a dispenser.
void WideRefrigerator(PieceMaker& m, const Surface& body) {
  constexpr float kWide = 0.45f;
  constexpr float kHigh = 1.78f;
  constexpr float kDeep = 0.66f;
  m.Box(kDark, {-kWide + 0.02f, 0, 0.02f}, {kWide - 0.02f, 0.06f, kDeep});
  m.Box(Shaded(body, 0.85f), {-kWide, 0.04f, 0}, {kWide, kHigh, kDeep});
  FridgeDoor(m, body, {-kWide, -0.02f, 0.06f, kHigh, kDeep}, false);
  FridgeDoor(m, body, {-0.02f, kWide, 0.06f, kHigh, kDeep}, true);
  Sheet(m, kDark, {-0.24f, 0.95f, kDeep + 0.053f}, 0.2f, 0.35f);
}

/// One door above the other.
void TallRefrigerator(PieceMaker& m, const Surface& body) {
  const float half = m.Draw(0.29f, 0.34f);
  const float height = m.Draw(1.62f, 1.95f);
  constexpr float kDeep = 0.6f;
  m.Box(kDark, {-half + 0.02f, 0, 0.02f}, {half - 0.02f, 0.06f, kDeep});
  m.Box(Shaded(body, 0.85f), {-half, 0.04f, 0}, {half, height, kDeep});
  const float split = m.Chance(0.6) ? 0.66f : height - 0.5f;
  FridgeDoor(m, body, {-half, half, 0.06f, split, kDeep}, false);
  FridgeDoor(m, body, {-half, half, split, height, kDeep}, false);
  const int notes = m.Chance(0.6) ? 3 : 0;  // under magnets
  for (int i = 0; i < notes; ++i) {
    const float y = 1.1f + 0.14f * static_cast<float>(i);
    Sheet(m, {"paper", i == 1 ? Rgb8{250, 220, 120} : kWhite},
          {m.Draw(-0.15f, 0.08f), y, kDeep + 0.053f}, 0.1f, 0.12f);
  }
}

void Refrigerator(PieceMaker& m) {
  static constexpr std::array<Rgb8, 4> kFifties = {Rgb8{176, 214, 200}, Rgb8{238, 226, 190},
                                                   Rgb8{190, 52, 48}, Rgb8{158, 196, 222}};
  switch (m.Below(4)) {
    case 0:
      return WideRefrigerator(m, m.palette().appliance);
    case 1:
      return TallRefrigerator(m, {"white_enamel", m.rng().Pick(kFifties)});
    case 2:
    case 3:
      return TallRefrigerator(m, m.palette().appliance);
  }
}

void Dishwasher(PieceMaker& m) {
  const Surface& body = m.palette().appliance;
  constexpr float kFront = 0.58f;
  m.Box(kDark, {-kHalf + 0.01f, 0, 0}, {kHalf - 0.01f, kKick, 0.52f});
  m.Box(Shaded(body, 0.7f), {-kHalf, kKick, 0}, {kHalf, kWorktop - kWorktopThick, kFront});
  m.Box(body, {-kHalf + 0.006f, kKick + 0.01f, kFront}, {kHalf - 0.006f, 0.73f, kFront + 0.02f});
  const Surface& panel = m.Chance(0.5) ? kBlackPlastic : body;
  m.Box(panel, {-kHalf + 0.006f, 0.74f, kFront}, {kHalf - 0.006f, 0.85f, kFront + 0.02f});
  m.Box(kSteel, {-0.24f, 0.67f, kFront + 0.03f}, {0.24f, 0.695f, kFront + 0.055f});
  for (int i = 0; i < 4; ++i) {
    Sheet(m, kGreyPlastic, {0.08f + 0.05f * static_cast<float>(i), 0.785f, kFront + 0.023f}, 0.03f,
          0.02f);
  }
  PlainWorktop(m, {-kHalf, kHalf});
  AboveWorktop(m, {-kHalf, kHalf});
  m.AddTop(kWorktop, {-kHalf, 0.05f}, {kHalf, 0.5f});
}

/// Open stand with a microwave, and what fits beside and below it.
void MicrowaveShelf(PieceMaker& m) {
  const Surface& wood = m.palette().wood;
  const Surface& posts = m.palette().metal;
  constexpr float kDepth = 0.42f;
  constexpr float kTop = 1.5f;
  for (const float x : {-kHalf, kHalf}) {
    for (const float z : {0.02f, kDepth - 0.02f}) Post(m, posts, {x, 0, z}, 0.035f, kTop);
  }
  for (const float y : {0.12f, 0.5f, 0.88f, kTop - 0.03f}) {
    m.Box(wood, {-kHalf, y, 0}, {kHalf, y + 0.03f, kDepth});
  }
  MicrowaveOven(m, {0, 0.91f, 0.03f});
  CookingPot(m, {-0.13f, 0.53f, 0.22f}, 0.12f, 0.14f);
  m.Turn(m.palette().ceramic, {0.15f, 0.53f, 0.22f},
         {{0.06f, 0.0f}, {0.12f, 0.08f}, {0.1f, 0.08f}, {0.0f, 0.02f}}, 8);
  m.TaperedBox(kWicker, {0, 0.15f, 0.21f}, {0.46f, 0.3f}, {0, 0.36f, 0.21f}, {0.52f, 0.34f});
  m.AddTop(kTop, {-kHalf, 0.0f}, {kHalf, kDepth});
}

constexpr std::array kKinds = {
    FurnitureKind{"dishwasher", Placement::kAgainstWall, 0.9f, Dishwasher},
    FurnitureKind{"microwave_shelf", Placement::kAgainstWall, 0.6f, MicrowaveShelf},
    FurnitureKind{"refrigerator", Placement::kAgainstWall, 0.9f, Refrigerator},
    FurnitureKind{"stove", Placement::kAgainstWall, 0.9f, Stove}};

}  // namespace

std::span<const FurnitureKind> KitchenAppliances() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
