// SPDX-License-Identifier: MIT
// What hotels have in their rooms, corridors and breakfast rooms.
#include <algorithm>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// A low rack of slats, a suitcase on some.
void LuggageRack(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.65f, 0.85f);
  const float high = m.Draw(0.42f, 0.52f);
  const float deep = m.Draw(0.45f, 0.55f);
  const Surface& wood = m.palette().wood;
  const Surface& legs = m.Chance(0.5) ? m.palette().metal : wood;
  Legs(m, legs,
       {LegStyle::kSquare, {-half + 0.03f, 0.06f}, {half - 0.03f, deep - 0.03f}, high, 0.04f});
  for (const float z : Spaced(0.06f, deep - 0.06f, 0.12f))
    m.Box(wood, {-half, high, z}, {half, high + 0.025f, z + 0.07f});
  m.Box(wood, {-half, high, 0}, {half, high + 0.3f, 0.025f});
  if (!m.Chance(0.5)) return m.AddTop(high + 0.025f, {-half, 0.05f}, {half, deep - 0.05f});
  const float size = m.Draw(0.24f, 0.3f);
  m.RoundedBox({"plastic", MutedColor(m)}, {-half + 0.06f, high + 0.025f, 0.05f},
               {half - 0.06f, high + size, deep - 0.04f}, 0.04f);
}

/// A cupboard with a small refrigerator, cups and a kettle.
void Minibar(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.9f, 1.2f);
  const float high = m.Draw(0.8f, 0.95f);
  const Surface& wood = m.Chance(0.6) ? m.palette().wood : m.palette().cabinet;
  OpenBody(m, wood, {-half, 0, 0}, {half, high, 0.5f}, 0.03f);
  m.Box(m.Chance(0.5) ? kBlackPlastic : kGreyPlastic, {-half + 0.04f, 0.04f, 0.06f},
        {0.0f, high - 0.08f, 0.47f});
  Panel(m, kChrome, {-0.08f, 0.4f * high, 0.47f}, {-0.06f, 0.7f * high, 0.49f});
  for (const float y : {0.03f, 0.5f * high})
    m.Box(wood, {0.03f, y, 0.03f}, {half - 0.03f, y + 0.02f, 0.48f});
  m.Box(kDark, {-half + 0.15f, high, 0.12f}, {0.1f, high + 0.02f, 0.42f});
  for (const float x : {-half + 0.25f, -half + 0.38f})
    m.Cylinder(kWhitePlastic, {x, high + 0.02f, 0.25f}, 0.04f, 0.08f, 6);
  m.Cylinder(kSteel, {0.0f, high + 0.02f, 0.27f}, 0.075f, 0.2f, 8);
  m.AddTop(high, {0.12f, 0.05f}, {half, 0.48f});
}

/// A cart with a rail of brass for luggage.
void BellCart(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.0f, 1.15f);
  const float high = m.Draw(1.6f, 1.85f);
  const Surface rail = m.Chance(0.6) ? kBrass : kChrome;
  constexpr float kDeep = 0.29f;
  for (const float x : {-half + 0.1f, half - 0.1f}) {
    for (const float z : {-0.2f, 0.2f}) m.Block(kRubber, {x, 0, z}, {0.05f, 0.16f, 0.16f});
  }
  m.Box({"plush_carpet", m.Chance(0.5) ? Rgb8{130, 30, 34} : Rgb8{50, 60, 90}},
        {-half, 0.16f, -kDeep}, {half, 0.24f, kDeep});
  for (const float x : {-half + 0.03f, half - 0.03f}) {
    for (const float z : {-kDeep + 0.03f, kDeep - 0.03f})
      m.Bar(rail, {x, 0.24f, z}, {x, high - 0.2f, z}, 0.018f, 6);
    for (const float z : {-kDeep + 0.03f, kDeep - 0.03f})
      m.Bar(rail, {x, high - 0.2f, z}, {0.6f * x, high, 0}, 0.018f, 6);
  }
  m.Bar(rail, {-0.6f * half, high, 0}, {0.6f * half, high, 0}, 0.018f, 6);
  const int cases = m.Below(4);
  for (int i = 0; i < cases; ++i) {
    const float x = 0.28f * (static_cast<float>(i) - 1.0f);
    m.Block({"plastic", MutedColor(m)}, {x, 0.24f, 0}, {0.24f, m.Draw(0.35f, 0.65f), 0.42f});
  }
}

/// Shelves of towels on wheels with a bag at one end.
void LinenCart(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.9f, 1.2f);
  const float high = m.Draw(1.05f, 1.25f);
  const Surface body = m.Chance(0.5) ? kGreyPlastic : Surface{"plastic", MutedColor(m)};
  for (const float x : {-half + 0.1f, half - 0.25f}) {
    for (const float z : {-0.18f, 0.18f}) m.Block(kRubber, {x, 0, z}, {0.05f, 0.14f, 0.12f});
  }
  const float end = half - 0.3f;
  m.Box(body, {-half, 0.14f, -0.27f}, {end, 0.2f, 0.27f});
  m.Box(body, {-half, high - 0.05f, -0.27f}, {end, high, 0.27f});
  m.Box(Shaded(body, 0.7f), {-half, 0.2f, -0.02f}, {end, high - 0.05f, 0.02f});
  for (const float x : {-half, end - 0.03f})
    m.Box(body, {x, 0.2f, -0.27f}, {x + 0.03f, high - 0.05f, 0.27f});
  for (const float y : {0.2f, 0.2f + 0.45f * (high - 0.25f)}) {
    if (y > 0.3f) m.Box(body, {-half + 0.03f, y - 0.02f, -0.26f}, {end - 0.03f, y, 0.26f});
    for (const float x : Spaced(-half + 0.18f, end - 0.15f, 0.3f)) {
      const float tall = m.Draw(0.12f, 0.3f);
      m.Block({"terry_towel"}, {x, y, 0.14f}, {0.26f, tall, 0.2f});
      m.Block({"linen"}, {x, y, -0.14f}, {0.26f, 0.8f * tall, 0.2f});
    }
  }
  m.TaperedBox({"canvas", MutedColor(m)}, {end + 0.15f, 0.15f, 0}, {0.26f, 0.4f},
               {end + 0.15f, high - 0.05f, 0}, {0.3f, 0.5f});
}

/// Food kept warm under hoods, bowls and baskets on a long counter.
void BuffetCounter(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.8f, 2.8f);
  const float deep = m.Draw(0.62f, 0.75f);
  constexpr float kTop = 0.9f;
  const Surface& front = m.Chance(0.5) ? m.palette().wood : m.palette().cabinet;
  m.Box(kDark, {-half + 0.04f, 0, 0}, {half - 0.04f, 0.08f, deep - 0.08f});
  m.Box(front, {-half + 0.02f, 0.08f, 0}, {half - 0.02f, kTop - 0.04f, deep - 0.03f});
  m.Box(m.palette().counter, {-half, kTop - 0.04f, 0}, {half, kTop, deep});
  for (const float x : Spaced(-half + 0.3f, half - 0.25f, 0.52f)) {
    switch (m.Below(4)) {
      case 0:
        m.Box(kSteel, {x - 0.2f, kTop, 0.15f}, {x + 0.2f, kTop + 0.12f, 0.5f});
        m.TaperedBox(kChrome, {x, kTop + 0.12f, 0.325f}, {0.4f, 0.35f}, {x, kTop + 0.26f, 0.325f},
                     {0.3f, 0.12f});
        break;
      case 1:
        m.Turn(m.palette().ceramic, {x, kTop, 0.33f}, {{0.08f, 0.0f}, {0.16f, 0.12f}, {0.0f, 0.1f}},
               8);
        break;
      case 2:
        m.TaperedBox(kWicker, {x, kTop, 0.33f}, {0.3f, 0.24f}, {x, kTop + 0.12f, 0.33f},
                     {0.4f, 0.32f});
        break;
      case 3:
        m.Cylinder(kSteel, {x, kTop, 0.3f}, 0.11f, 0.4f, 10);
        break;
    }
  }
  if (m.Chance(0.5)) {  // a guard of glass in front of the food
    m.Box(kGlass, {-half + 0.1f, kTop + 0.3f, deep - 0.1f},
          {half - 0.1f, kTop + 0.52f, deep - 0.09f});
    for (const float x : {-half + 0.1f, half - 0.12f})
      m.Box(kChrome, {x, kTop, deep - 0.11f}, {x + 0.02f, kTop + 0.52f, deep - 0.08f});
  }
}

/// A number beside a door.
void RoomSign(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.14f, 0.24f);
  const Surface plate = m.Chance(0.4) ? kBrass : Surface{"plastic", MutedColor(m)};
  Panel(m, plate, {-half, 0, 0}, {half, 1.1f * half, 0.012f});
  const int digits = m.Between(2, 3);
  for (int i = 0; i < digits; ++i) {
    const float x = half * (0.55f * static_cast<float>(i) - 0.7f);
    Panel(m, kWhitePlastic, {x, 0.3f * half, 0.012f},
          {x + m.Draw(0.12f, 0.35f) * half, 0.85f * half, 0.014f});
  }
}

/// Doors of a lift in their frame, shut, with the call button beside them.
void LiftDoors(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.2f, 1.5f);
  const float high = m.Draw(2.15f, 2.35f);
  const Surface frame = m.Chance(0.5) ? kSteel : Surface{"black_marble"};
  const Surface leaf = m.Chance(0.85) ? kSteel : Surface{"painted_wood", MutedColor(m)};
  m.Box(frame, {-half, 0, 0}, {-half + 0.16f, high, 0.1f});
  m.Box(frame, {half - 0.16f, 0, 0}, {half, high, 0.1f});
  m.Box(frame, {-half + 0.16f, high - 0.2f, 0}, {half - 0.16f, high, 0.1f});
  m.Box(kDark, {-half + 0.16f, 0, 0}, {half - 0.16f, high - 0.2f, 0.02f});
  Panel(m, leaf, {-half + 0.16f, 0.01f, 0.02f}, {-0.005f, high - 0.2f, 0.05f});
  Panel(m, leaf, {0.005f, 0.01f, 0.02f}, {half - 0.16f, high - 0.2f, 0.05f});
  Panel(m, kDark, {-0.12f, high - 0.14f, 0.1f}, {0.12f, high - 0.06f, 0.105f});
  Panel(m, kBlackPlastic, {half - 0.11f, 1.0f, 0.1f}, {half - 0.05f, 1.2f, 0.11f});
}

constexpr std::array kKinds = {
    FurnitureKind{"bell_cart", Placement::kFree, 0.1f, BellCart},
    FurnitureKind{"buffet_counter", Placement::kAgainstWall, 0.9f, BuffetCounter, 1.4f, 4.2f},
    FurnitureKind{"lift_doors", Placement::kAgainstWall, 1.0f, LiftDoors},
    FurnitureKind{"linen_cart", Placement::kFree, 0.1f, LinenCart},
    FurnitureKind{"luggage_rack", Placement::kAgainstWall, 0.4f, LuggageRack},
    FurnitureKind{"minibar", Placement::kAgainstWall, 0.6f, Minibar},
    FurnitureKind{"room_sign", Placement::kOnWall, 0.0f, RoomSign}};

}  // namespace

std::span<const FurnitureKind> Hotel() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
