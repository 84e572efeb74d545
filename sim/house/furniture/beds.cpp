// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kHead = 0.08f;   // depth taken by the headboard
constexpr float kLength = 2.0f;  // of the mattress
constexpr float kMattress = 0.2f;

struct BedShape {
  float width = 1.6f;
  float base = 0.3f;  // height under the mattress
  int pillows = 2;
};

void IronHead(PieceMaker& m, float half, float height) {
  const Surface iron = m.Chance(0.5) ? kBlackMetal : kBrass;
  for (const float x : {-half, half}) {
    m.Bar(iron, {x, 0, 0.04f}, {x, height, 0.04f}, 0.022f, 5);
    m.Ball(iron, {x, height + 0.02f, 0.04f}, {0.04f, 0.04f, 0.04f}, 6);
  }
  for (const float y : {0.55f, height - 0.06f}) {
    m.Bar(iron, {-half, y, 0.04f}, {half, y, 0.04f}, 0.018f, 4);
  }
  const int bars = half > 0.6f ? 7 : 4;
  for (int i = 1; i <= bars; ++i) {
    const float x = half * (2.0f * static_cast<float>(i) / static_cast<float>(bars + 1) - 1.0f);
    Post(m, iron, {x, 0.55f, 0.04f}, 0.02f, height - 0.61f);
  }
}

void SlattedHead(PieceMaker& m, float half, float height) {
  const Surface& wood = m.palette().wood;
  for (const float x : {-half + 0.035f, half - 0.035f}) Post(m, wood, {x, 0, 0.04f}, 0.07f, height);
  for (int i = 0; i < 4; ++i) {
    const float y = height - 0.02f - 0.14f * static_cast<float>(i);
    m.Box(wood, {-half + 0.05f, y - 0.1f, 0.025f}, {half - 0.05f, y, 0.055f});
  }
}

void PaddedHead(PieceMaker& m, float half, float height) {
  const Surface& cloth = m.Chance(0.5) ? m.palette().fabric : m.palette().accent;
  const int panels = half > 0.6f ? 4 : 2;
  const float width = 2.0f * half / static_cast<float>(panels);
  for (int i = 0; i < panels; ++i) {
    const float x = -half + width * static_cast<float>(i);
    m.RoundedBox(cloth, {x, 0.1f, 0}, {x + width, height, kHead + 0.02f}, 0.03f);
  }
}

void ArchedHead(PieceMaker& m, float half, float height) {
  const float top = height - 0.25f;
  const std::array<Vec2, 8> outline = {Vec2(-half, 0),
                                       Vec2(half, 0),
                                       Vec2(half, top),
                                       Vec2(0.8f * half, top + 0.13f),
                                       Vec2(0.4f * half, top + 0.22f),
                                       Vec2(-0.4f * half, top + 0.22f),
                                       Vec2(-0.8f * half, top + 0.13f),
                                       Vec2(-half, top)};
  // A prism rises along its own y: lay that towards the front, its z downwards.
  std::array<Vec2, 8> flat;
  for (std::size_t i = 0; i < outline.size(); ++i) flat[i] = {outline[i].x(), -outline[i].y()};
  const Frame frame(&m, Turned({0, 0, 0}, 0.0f, kQuarterTurn));
  m.Prism(FrameSurface(m), flat, 0.0f, kHead - 0.02f);
}

void Head(PieceMaker& m, float half, int style) {
  const float height = m.Draw(0.95f, 1.2f);
  switch (style) {
    case 0:
      return IronHead(m, half, height);
    case 1:
      return SlattedHead(m, half, height);
    case 2:
      return PaddedHead(m, half, height);
    case 3:
      return ArchedHead(m, half, height);
    default:
      m.Box(m.palette().wood, {-half, 0.0f, 0}, {half, height, kHead - 0.02f});
  }
}

/// Mattress, duvet, pillows and what lies on them, on a base of shape.base.
void Bedding(PieceMaker& m, const BedShape& shape) {
  const float half = 0.5f * shape.width;
  const float top = shape.base + kMattress;
  const Palette& palette = m.palette();
  Cushion(m, kWhiteLinen, {-half + 0.02f, shape.base, kHead}, {half - 0.02f, top, kHead + kLength},
          0.03f);
  const float fold = kHead + m.Draw(0.5f, 0.75f);
  m.RoundedBox(palette.bedding, {-half - 0.03f, top - 0.2f, fold},
               {half + 0.03f, top + 0.075f, kHead + kLength + 0.03f}, 0.09f);
  m.Box(Shaded(kWhiteLinen, 0.96f), {-half - 0.035f, top - 0.15f, fold - 0.02f},
        {half + 0.035f, top + 0.085f, fold + 0.2f});
  if (m.Chance(0.5)) {  // a throw over the foot end
    const float z = kHead + kLength - m.Draw(0.65f, 0.8f);
    m.Box(palette.accent, {-half - 0.04f, top - 0.22f, z},
          {half + 0.04f, top + 0.085f, z + m.Draw(0.4f, 0.55f)});
  }
  const float width = shape.width / static_cast<float>(shape.pillows);
  for (int i = 0; i < shape.pillows; ++i) {
    const float x = -half + (static_cast<float>(i) + 0.5f) * width;
    const Frame frame(&m, Turned({x, top + 0.02f, kHead + 0.3f}, m.Draw(-0.08f, 0.08f), 0.45f));
    Pillow(m, palette.bedding, {-0.31f, 0, -0.24f}, {0.31f, 0.19f, 0.2f});
  }
  const int cushions = shape.pillows > 1 ? m.Below(3) : m.Below(2);
  for (int i = 0; i < cushions; ++i) {
    const float x = 0.24f * (2.0f * static_cast<float>(i) - static_cast<float>(cushions - 1));
    const Frame frame(&m, Turned({x, top + 0.06f, kHead + 0.48f}, m.Draw(-0.2f, 0.2f), 0.8f));
    Pillow(m, i % 2 == 0 ? palette.accent : palette.other_accent, {-0.22f, 0, -0.2f},
           {0.22f, 0.14f, 0.22f});
  }
}

void Bed(PieceMaker& m, const BedShape& shape) {
  const float half = 0.5f * shape.width;
  const float end = kHead + kLength;
  const int style = m.Below(5);
  Head(m, half + 0.02f, style);
  const Surface& wood = style == 0 ? kBlackMetal : m.palette().wood;
  if (style == 2) {  // an upholstered base goes with the padded head
    m.Box(m.palette().fabric, {-half, 0.06f, kHead}, {half, shape.base, end});
  } else {
    const LegSet legs = {LegStyle::kSquare, {-half, kHead}, {half, end}, shape.base - 0.14f, 0.07f};
    Legs(m, wood, legs);
    m.Box(wood, {-half, shape.base - 0.16f, kHead - 0.03f},
          {half, shape.base + 0.02f, end + 0.02f});
  }
  if (style == 0) {  // a low railing at the foot
    const float z = end + 0.04f;
    for (const float x : {-half, half}) Post(m, wood, {x, 0, z}, 0.045f, 0.72f);
    for (const float y : {0.45f, 0.66f})
      m.Box(wood, {-half, y, z - 0.015f}, {half, y + 0.035f, z + 0.015f});
  } else if (style == 1 && m.Chance(0.6)) {
    m.Box(wood, {-half - 0.01f, 0, end + 0.03f}, {half + 0.01f, 0.62f, end + 0.07f});
  }
  Bedding(m, shape);
}

void SingleBed(PieceMaker& m) {
  Bed(m, {m.Draw(0.9f, 1.05f), m.Draw(0.26f, 0.34f), 1});
}

void DoubleBed(PieceMaker& m) {
  Bed(m, {m.Draw(1.4f, 1.8f), m.Draw(0.26f, 0.36f), 2});
}

/// One berth along x: frame, mattress, pillow and duvet; `top` is the mattress's.
void Berth(PieceMaker& m, const Surface& wood, float top) {
  constexpr float kHalf = 1.02f;
  constexpr float kDepth = 0.95f;
  m.Box(wood, {-kHalf, top - 0.26f, 0.02f}, {kHalf, top - 0.1f, kDepth});
  m.Box(kWhiteLinen, {-kHalf + 0.04f, top - 0.1f, 0.06f}, {kHalf - 0.04f, top, kDepth - 0.03f});
  Cushion(m, m.palette().bedding, {-kHalf + 0.55f, top - 0.12f, 0.05f},
          {kHalf - 0.03f, top + 0.06f, kDepth - 0.01f}, 0.04f);
  const Frame frame(&m, {-kHalf + 0.32f, top, 0.5f * kDepth});
  Pillow(m, m.palette().accent, {-0.2f, 0, -0.3f}, {0.2f, 0.15f, 0.3f});
}

void BunkBed(PieceMaker& m) {
  const Surface wood = FrameSurface(m);
  constexpr float kHalf = 1.05f;
  constexpr float kDepth = 0.97f;
  const float high = m.Draw(1.55f, 1.75f);
  for (const float x : {-kHalf + 0.035f, kHalf - 0.035f}) {
    for (const float z : {0.035f, kDepth - 0.035f}) Post(m, wood, {x, 0, z}, 0.07f, high);
    for (const float y : {0.6f, high - 0.1f}) {
      m.Box(wood, {x - 0.02f, y, 0.05f}, {x + 0.02f, y + 0.1f, kDepth - 0.05f});
    }
  }
  Berth(m, wood, 0.42f);
  Berth(m, wood, high - 0.3f);
  // A rail keeps the sleeper in; the ladder leads up beside it.
  const float ladder = m.Chance(0.5) ? 0.62f : -0.98f;
  for (const float y : {high - 0.2f, high - 0.07f}) {
    const float from = ladder > 0 ? -kHalf + 0.05f : ladder + 0.45f;
    const float to = ladder > 0 ? ladder - 0.03f : kHalf - 0.05f;
    m.Box(wood, {from, y, kDepth - 0.04f}, {to, y + 0.07f, kDepth - 0.01f});
  }
  const Frame frame(&m, Turned({ladder, 0, kDepth + 0.16f}, 0.0f, -0.1f));
  for (const float x : {0.02f, 0.38f}) Post(m, wood, {x, 0, 0}, 0.045f, high);
  for (int i = 1; i <= 5; ++i) {
    const float y = 0.27f * static_cast<float>(i);
    m.Box(wood, {0.02f, y, -0.02f}, {0.38f, y + 0.035f, 0.02f});
  }
}

void Crib(PieceMaker& m) {
  const Surface wood = m.Chance(0.5) ? kWhitePaint : m.palette().wood;
  constexpr float kHalf = 0.65f;
  constexpr float kDepth = 0.72f;
  constexpr float kTop = 0.95f;
  for (const float x : {-kHalf + 0.025f, kHalf - 0.025f}) {
    for (const float z : {0.025f, kDepth - 0.025f}) Post(m, wood, {x, 0, z}, 0.05f, kTop + 0.03f);
    for (const float y : {0.3f, kTop - 0.05f}) {
      m.Box(wood, {x - 0.015f, y, 0.03f}, {x + 0.015f, y + 0.05f, kDepth - 0.03f});
    }
    for (int i = 1; i <= 4; ++i) {
      Post(m, wood, {x, 0.32f, 0.144f * static_cast<float>(i)}, 0.022f, kTop - 0.35f);
    }
  }
  for (const float z : {0.025f, kDepth - 0.025f}) {
    for (const float y : {0.3f, kTop - 0.05f}) {
      m.Box(wood, {-kHalf, y, z - 0.015f}, {kHalf, y + 0.05f, z + 0.015f});
    }
    for (int i = 1; i <= 9; ++i) {
      Post(m, wood, {-kHalf + 0.13f * static_cast<float>(i), 0.32f, z}, 0.022f, kTop - 0.35f);
    }
  }
  m.Box(kWhiteLinen, {-kHalf + 0.04f, 0.34f, 0.04f}, {kHalf - 0.04f, 0.46f, kDepth - 0.04f});
  Cushion(m, m.palette().bedding, {-0.2f, 0.46f, 0.05f}, {kHalf - 0.05f, 0.53f, kDepth - 0.05f},
          0.03f);
  const Frame frame(&m, {-0.42f, 0.46f, 0.5f * kDepth});
  Pillow(m, m.palette().accent, {-0.13f, 0, -0.2f}, {0.13f, 0.1f, 0.2f});
}

constexpr std::array kKinds = {
    FurnitureKind{"bunk_bed", Placement::kAgainstWall, 0.7f, BunkBed},
    FurnitureKind{"crib", Placement::kAgainstWall, 0.6f, Crib},
    FurnitureKind{"double_bed", Placement::kAgainstWall, 0.6f, DoubleBed},
    FurnitureKind{"single_bed", Placement::kAgainstWall, 0.6f, SingleBed}};

}  // namespace

std::span<const FurnitureKind> Beds() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
