// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kFoot = 0.1f;  // legs under the upholstery
constexpr float kBack = 0.2f;  // thickness of the backrest

struct SofaShape {
  Surface cover;
  float width = 2.0f;
  float depth = 0.9f;
  float seat = 0.43f;
  float back = 0.82f;
  float arm = 0.18f;  // width; its height is that of the seat and a bit
  bool round_arms = false;
  int cushions = 2;
};

SofaShape DrawShape(PieceMaker& m, float width) {
  SofaShape shape;
  shape.cover = m.palette().fabric;
  if (m.Chance(0.25))
    shape.cover = {"leather", m.Chance(0.5) ? Rgb8{150, 98, 66} : Rgb8{90, 70, 60}};
  shape.width = width;
  shape.depth = m.Draw(0.85f, 0.98f);
  shape.seat = m.Draw(0.4f, 0.46f);
  shape.back = m.Draw(0.74f, 0.92f);
  shape.arm = m.Draw(0.12f, 0.24f);
  shape.round_arms = m.Chance(0.4);
  shape.cushions = width > 1.85f && m.Chance(0.6) ? 3 : 2;
  return shape;
}

void Arm(PieceMaker& m, const SofaShape& shape, float x0) {
  const float height = shape.seat + 0.18f;
  const float x1 = x0 + shape.arm;
  if (!shape.round_arms) {
    m.RoundedBox(shape.cover, {x0, kFoot, 0}, {x1, height, shape.depth}, 0.05f);
    return;
  }
  const float radius = 0.5f * shape.arm + 0.02f;
  m.Box(shape.cover, {x0 + 0.02f, kFoot, 0}, {x1 - 0.02f, height - radius, shape.depth - 0.02f});
  const Frame frame(&m, Turned({x0 + 0.5f * shape.arm, height - radius, 0}, 0.0f, kQuarterTurn));
  m.Cylinder(Shaded(shape.cover, 0.97f), {0, 0, 0}, radius, shape.depth, 10);
}

/// Seat and back cushions between x0 and x1, on a base; the back is at z = 0.
void Seats(PieceMaker& m, const SofaShape& shape, float x0, float x1, int count) {
  m.Box(Shaded(shape.cover, 0.9f), {x0, kFoot, 0.05f},
        {x1, shape.seat - 0.14f, shape.depth - 0.02f});
  m.RoundedBox(shape.cover, {x0, kFoot, 0}, {x1, shape.back, kBack}, 0.06f);
  const float width = (x1 - x0) / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float a = x0 + width * static_cast<float>(i) + 0.008f;
    const float b = a + width - 0.016f;
    m.RoundedBox(shape.cover, {a, shape.seat - 0.13f, kBack - 0.02f}, {b, shape.seat, shape.depth},
                 0.05f);
    const Frame frame(&m, Turned({0, shape.seat - 0.01f, kBack + 0.03f}, 0.0f, -0.22f));
    m.RoundedBox(Shaded(shape.cover, 1.06f), {a, 0, 0}, {b, shape.back - shape.seat + 0.04f, 0.16f},
                 0.06f);
  }
}

void ThrowPillow(PieceMaker& m, const Surface& surface, const Vec& at, float yaw) {
  const Frame frame(&m, Turned(at, yaw, 1.15f));
  Pillow(m, surface, {-0.22f, -0.02f, -0.22f}, {0.22f, 0.14f, 0.22f});
}

void SofaLegs(PieceMaker& m, const SofaShape& shape) {
  const Surface& surface = m.Chance(0.5) ? m.palette().wood : m.palette().metal;
  Legs(m, surface,
       {LegStyle::kTapered,
        {-0.5f * shape.width + 0.04f, 0.04f},
        {0.5f * shape.width - 0.04f, shape.depth - 0.04f},
        kFoot,
        0.06f});
}

void Sofa(PieceMaker& m) {
  SofaShape shape = DrawShape(m, m.Width(1.6f, 2.4f, 0.04f));
  const float half = 0.5f * shape.width;
  const bool has_chaise = shape.width > 1.9f && m.Chance(0.3);
  SofaLegs(m, shape);
  Seats(m, shape, -half + shape.arm, half - shape.arm, shape.cushions);
  Arm(m, shape, -half);
  Arm(m, shape, half - shape.arm);
  if (has_chaise) {  // the right seat goes on to the front
    const float width = (shape.width - 2.0f * shape.arm) / static_cast<float>(shape.cushions);
    const float x1 = half - shape.arm;
    m.Box(Shaded(shape.cover, 0.9f), {x1 - width, 0.03f, shape.depth - 0.04f},
          {half, shape.seat - 0.13f, 1.5f});
    m.RoundedBox(shape.cover, {x1 - width, shape.seat - 0.13f, shape.depth - 0.04f},
                 {half, shape.seat, 1.52f}, 0.05f);
  }
  const float y = shape.seat + 0.17f;
  const float z = kBack + 0.27f;
  ThrowPillow(m, m.palette().accent, {-half + shape.arm + 0.25f, y, z}, 0.35f);
  if (m.Chance(0.7)) {
    ThrowPillow(m, m.palette().other_accent, {half - shape.arm - 0.25f, y, z}, -0.35f);
  }
  if (m.Chance(0.3)) {  // a throw over the back
    const float x = m.Draw(-0.4f, 0.1f) * half;
    m.Box(m.palette().accent, {x, shape.back - 0.35f, -0.01f},
          {x + 0.5f, shape.back + 0.02f, kBack + 0.02f});
  }
}

void CornerSofa(PieceMaker& m) {
  SofaShape shape = DrawShape(m, m.Draw(2.1f, 2.7f));
  const float length = m.Draw(1.7f, 2.2f);  // of the leg along the left wall
  const float half = 0.5f * shape.width;
  Seats(m, shape, -half + shape.depth, half - shape.arm, 2);
  Arm(m, shape, half - shape.arm);
  // The corner, then the leg along the left wall: the same seats turned by a quarter.
  m.Box(Shaded(shape.cover, 0.9f), {-half + 0.05f, kFoot, 0.05f},
        {-half + shape.depth, shape.seat - 0.13f, shape.depth});
  m.RoundedBox(shape.cover, {-half, kFoot, 0}, {-half + shape.depth, shape.back, kBack}, 0.06f);
  m.RoundedBox(shape.cover, {-half + kBack, shape.seat - 0.13f, kBack},
               {-half + shape.depth, shape.seat, shape.depth}, 0.04f);
  m.RoundedBox(shape.cover, {-half, kFoot, kBack}, {-half + kBack, shape.back, shape.depth}, 0.06f);
  const float rest = length - shape.depth;
  {
    const Frame frame(&m, {-half, 0, shape.depth + 0.5f * rest}, kQuarterTurn);
    Seats(m, shape, -0.5f * rest, 0.5f * rest, rest > 1.0f ? 2 : 1);
  }
  SofaLegs(m, shape);
  Legs(m, m.palette().wood,
       {LegStyle::kTapered,
        {-half + 0.04f, shape.depth},
        {-half + shape.depth - 0.06f, length - 0.04f},
        kFoot,
        0.06f});
  const float y = shape.seat + 0.17f;
  ThrowPillow(m, m.palette().accent, {-half + kBack + 0.3f, y, kBack + 0.3f}, 0.8f);
  ThrowPillow(m, m.palette().other_accent, {half - shape.arm - 0.26f, y, kBack + 0.27f}, -0.3f);
}

/// Club and wing chairs.
void UpholsteredChair(PieceMaker& m, const SofaShape& shape, bool has_wings) {
  const float half = 0.5f * shape.width;
  SofaLegs(m, shape);
  Seats(m, shape, -half + shape.arm, half - shape.arm, 1);
  for (const float x : {-half, half - shape.arm}) {
    Arm(m, shape, x);
    if (!has_wings) continue;
    m.RoundedBox(shape.cover, {x + 0.02f, shape.seat, 0}, {x + 0.13f, shape.back, 0.34f}, 0.04f);
  }
}

/// A frame of wood with two cushions in it.
void LoungeChair(PieceMaker& m, const SofaShape& shape) {
  const float half = 0.5f * shape.width;
  const Surface& wood = m.palette().wood;
  for (const float x : {-half + 0.03f, half - 0.03f}) {
    Post(m, wood, {x, 0, 0.06f}, 0.05f, 0.6f);
    Post(m, wood, {x, 0, shape.depth - 0.06f}, 0.05f, 0.6f);
    m.Box(wood, {x - 0.04f, 0.6f, 0}, {x + 0.04f, 0.635f, shape.depth});
  }
  m.Box(wood, {-half + 0.03f, 0.24f, 0.05f}, {half - 0.03f, 0.29f, shape.depth - 0.05f});
  Cushion(m, shape.cover, {-half + 0.07f, 0.29f, 0.1f}, {half - 0.07f, 0.44f, shape.depth}, 0.03f);
  const Frame frame(&m, Turned({0, 0.42f, 0.1f}, 0.0f, -0.28f));
  m.RoundedBox(shape.cover, {-half + 0.07f, 0, 0}, {half - 0.07f, 0.5f, 0.14f}, 0.05f);
}

void Armchair(PieceMaker& m) {
  SofaShape shape = DrawShape(m, m.Draw(0.76f, 0.92f));
  shape.depth = m.Draw(0.78f, 0.88f);
  if (m.Chance(0.4)) shape.cover = m.palette().accent;
  switch (m.Below(3)) {
    case 0:
      UpholsteredChair(m, shape, false);
      break;
    case 1:
      shape.back = m.Draw(1.0f, 1.1f);
      UpholsteredChair(m, shape, true);
      break;
    case 2:
      LoungeChair(m, shape);
      break;
  }
  if (m.Chance(0.5)) {
    ThrowPillow(m, m.palette().other_accent, {0, shape.seat + 0.15f, 0.42f}, 0.1f);
  }
}

void Ottoman(PieceMaker& m) {
  const Surface& cover = m.Chance(0.5) ? m.palette().accent : m.palette().fabric;
  const float half = m.Draw(0.25f, 0.34f);
  const float height = m.Draw(0.36f, 0.44f);
  if (m.Chance(0.5)) {  // a round pouf
    m.Turn(cover, {0, 0, 0},
           {{0.85f * half, 0.0f},
            {half, 0.25f * height},
            {half, 0.75f * height},
            {0.8f * half, height},
            {0.0f, 0.97f * height}},
           12);
  } else {
    Legs(m, m.palette().wood, {LegStyle::kTapered, {-half, -half}, {half, half}, 0.14f, 0.05f});
    m.RoundedBox(cover, {-half, 0.12f, -half}, {half, height, half}, 0.06f);
  }
  m.AddTop(height, {-0.6f * half, -0.6f * half}, {0.6f * half, 0.6f * half});
}

constexpr std::array kKinds = {
    FurnitureKind{"armchair", Placement::kAgainstWall, 0.6f, Armchair},
    FurnitureKind{"corner_sofa", Placement::kCorner, 0.7f, CornerSofa},
    FurnitureKind{"ottoman", Placement::kFree, 0.3f, Ottoman},
    FurnitureKind{"sofa", Placement::kAgainstWall, 0.8f, Sofa, 1.4f, 2.6f}};

}  // namespace

std::span<const FurnitureKind> Sofas() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
