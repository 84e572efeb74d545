// SPDX-License-Identifier: MIT
// What clinics and hospitals are fitted with besides beds.
#include <algorithm>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

void Wheelchair(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.56f, 0.64f);
  const Surface cloth{"canvas", m.Chance(0.6) ? Rgb8{40, 42, 48} : BrightColor(m)};
  const Surface frame = m.Chance(0.6) ? kChrome : Surface{"painted_wood", BrightColor(m)};
  for (const float x : {-half + 0.02f, half - 0.02f}) {
    {
      const Frame wheel(&m, {x, 0, 0});
      Hoop(m, kRubber, {0, 0.3f, -0.1f}, 0.27f, 0.03f);
      m.Box(kSteel, {-0.01f, 0.28f, -0.36f}, {0.01f, 0.31f, 0.16f});
      m.Box(kSteel, {-0.01f, 0.04f, -0.11f}, {0.01f, 0.56f, -0.09f});
    }
    const float in = x > 0.0f ? x - 0.06f : x + 0.06f;
    m.Box(kRubber, {in - 0.015f, 0, 0.22f}, {in + 0.015f, 0.14f, 0.36f});
    m.Bar(frame, {in, 0.12f, 0.28f}, {in, 0.68f, 0.22f}, 0.013f, 5);
    m.Bar(frame, {in, 0.45f, -0.22f}, {in, 0.93f, -0.26f}, 0.013f, 5);
    m.Box(kBlackPlastic, {in - 0.025f, 0.67f, -0.2f}, {in + 0.025f, 0.71f, 0.18f});
    m.Bar(frame, {in, 0.92f, -0.26f}, {in, 0.93f, -0.38f}, 0.015f, 5);
    m.Box(kBlackPlastic, {0.6f * in - 0.06f, 0.1f, 0.38f}, {0.6f * in + 0.06f, 0.13f, 0.54f});
    m.Bar(frame, {in, 0.46f, 0.24f}, {0.8f * in, 0.12f, 0.44f}, 0.012f, 5);
  }
  m.Box(cloth, {-half + 0.08f, 0.45f, -0.22f}, {half - 0.08f, 0.5f, 0.24f});
  m.Box(cloth, {-half + 0.08f, 0.52f, -0.28f}, {half - 0.08f, 0.9f, -0.24f});
}

void IvStand(PieceMaker& m) {
  const float high = m.Draw(1.75f, 2.0f);
  for (int i = 0; i < 5; ++i) {
    const Frame frame(&m, {0, 0, 0}, 1.2566f * static_cast<float>(i));
    m.Box(kGreyPlastic, {-0.015f, 0.03f, 0}, {0.015f, 0.07f, 0.28f});
    m.Box(kRubber, {-0.015f, 0, 0.22f}, {0.015f, 0.05f, 0.28f});
  }
  m.Bar(kChrome, {0, 0.05f, 0}, {0, high, 0}, 0.014f, 6);
  m.Bar(kChrome, {-0.14f, high - 0.01f, 0}, {0.14f, high - 0.01f, 0}, 0.01f, 4);
  const int bags = m.Between(1, 2);
  for (int i = 0; i < bags; ++i) {
    const float x = i == 0 ? 0.12f : -0.12f;
    m.Box({"plastic", {206, 222, 230}}, {x - 0.06f, high - 0.3f, -0.02f},
          {x + 0.06f, high - 0.02f, 0.02f});
  }
  if (m.Chance(0.5)) {
    m.Box(kWhitePlastic, {-0.08f, 1.05f, 0.01f}, {0.08f, 1.3f, 0.13f});
    Panel(m, kDark, {-0.05f, 1.18f, 0.13f}, {0.05f, 1.26f, 0.135f});
  }
}

void MedicalTrolley(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.55f, 0.75f);
  const float high = m.Draw(0.88f, 1.0f);
  const Surface front{"plastic", m.Chance(0.6) ? BrightColor(m) : Rgb8{120, 160, 190}};
  for (const float x : {-half + 0.05f, half - 0.05f}) {
    for (const float z : {-0.2f, 0.2f}) m.Block(kRubber, {x, 0, z}, {0.04f, 0.1f, 0.1f});
  }
  m.Box(kWhitePlastic, {-half, 0.1f, -0.25f}, {half, high, 0.25f});
  const int rows = m.Between(3, 5);
  for (int i = 0; i < rows; ++i) {
    const float share = (high - 0.18f) / static_cast<float>(rows);
    const float y = 0.14f + share * static_cast<float>(i);
    Panel(m, front, {-half + 0.02f, y, 0.25f}, {half - 0.02f, y + share - 0.02f, 0.265f});
    Panel(m, kGreyPlastic, {-0.1f, y + 0.6f * share, 0.265f},
          {0.1f, y + 0.6f * share + 0.02f, 0.285f});
  }
  m.Box(kGreyPlastic, {-half - 0.02f, high, -0.26f}, {half + 0.02f, high + 0.03f, 0.27f});
  const float x = m.Draw(-0.4f, 0.4f) * half;
  m.Block(m.Chance(0.5) ? kSteel : kPaper, {x, high + 0.03f, 0},
          {0.2f, m.Draw(0.05f, 0.2f), 0.18f});
  m.AddTop(high + 0.03f, {-half, -0.25f}, {half, 0.25f});
}

/// A screen with curves over a pole with a basket.
void MonitorStand(PieceMaker& m) {
  const float high = m.Draw(1.25f, 1.4f);
  for (const float turn : {0.785f, -0.785f}) {
    const Frame frame(&m, {0, 0, 0}, turn);
    m.Box(kGreyPlastic, {-0.26f, 0, -0.03f}, {0.26f, 0.07f, 0.03f});
  }
  m.Bar(kWhitePlastic, {0, 0.05f, 0}, {0, high, 0}, 0.025f, 6);
  m.Box(kSteel, {-0.15f, 0.7f, -0.12f}, {0.15f, 0.85f, 0.12f});
  m.Box(kWhitePlastic, {-0.19f, high - 0.02f, -0.08f}, {0.19f, high + 0.3f, 0.07f});
  Panel(m, kDark, {-0.16f, high + 0.02f, 0.07f}, {0.16f, high + 0.27f, 0.075f});
  for (int i = 0; i < 3; ++i) {
    const float y = high + 0.06f + 0.07f * static_cast<float>(i);
    Panel(m, {"plastic", BrightColor(m)}, {-0.14f, y, 0.075f},
          {m.Draw(0.02f, 0.14f), y + 0.015f, 0.078f});
  }
}

/// Seats side by side on one beam, looking to +z.
void SeatRow(PieceMaker& m) {
  const float width = m.Width(1.6f, 2.3f);
  const float half = 0.5f * width;
  const int seats = std::max(2, static_cast<int>(width / 0.56f));
  const float share = width / static_cast<float>(seats);
  const int look = m.Below(3);
  const Surface shell = look == 0   ? kSteel
                        : look == 1 ? Surface{"plastic", MutedColor(m)}
                                    : m.palette().fabric;
  const float tall = m.Draw(0.36f, 0.46f);
  m.Box(kBlackMetal, {-half, 0.33f, -0.05f}, {half, 0.39f, 0.03f});
  for (const float x : {-0.75f * half, 0.75f * half}) {
    m.Box(kBlackMetal, {x - 0.03f, 0.03f, -0.04f}, {x + 0.03f, 0.33f, 0.02f});
    m.Box(kBlackMetal, {x - 0.03f, 0, -0.26f}, {x + 0.03f, 0.03f, 0.26f});
  }
  for (int i = 0; i < seats; ++i) {
    const float x0 = -half + share * static_cast<float>(i) + 0.02f;
    const float x1 = x0 + share - 0.04f;
    m.Box(shell, {x0, 0.39f, -0.22f}, {x1, 0.44f, 0.24f});
    const Frame frame(&m, Turned({0, 0.43f, -0.2f}, 0.0f, -0.18f));
    m.Box(shell, {x0, 0, -0.03f}, {x1, tall, 0.01f});
  }
}

void HandRail(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.6f, 2.5f);
  const Surface rail = m.Chance(0.6) ? m.palette().wood : Surface{"plastic", MutedColor(m)};
  m.Box(rail, {-half, 0, 0.03f}, {half, m.Draw(0.07f, 0.14f), 0.07f});
  for (const float x : Spaced(-half + 0.1f, half - 0.05f, 0.7f)) {
    m.Box(kSteel, {x - 0.02f, 0.02f, 0}, {x + 0.02f, 0.05f, 0.03f});
  }
}

/// Cupboard with panes above and doors below.
void MedicineCabinet(PieceMaker& m) {
  const float width = m.Width(0.8f, 1.2f);
  const float half = 0.5f * width;
  const float high = m.Draw(1.75f, 2.0f);
  const Surface body = m.Chance(0.7) ? kWhitePaint : m.palette().cabinet;
  const int doors = std::max(2, static_cast<int>(width / 0.45f));
  Body(m, body, {-half, 0, 0}, {half, 0.85f, 0.4f});
  Doors(m, body, {-half, half, 0.06f, 0.83f, 0.4f}, doors);
  OpenBody(m, body, {-half, 0.85f, 0}, {half, high, 0.36f}, 0.025f);
  for (const float y : Spaced(0.88f, high - 0.2f, 0.32f)) {
    m.Box(body, {-half + 0.025f, y, 0.02f}, {half - 0.025f, y + 0.02f, 0.33f});
    for (const float x : Spaced(-half + 0.1f, half - 0.08f, 0.16f)) {
      if (m.Chance(0.25)) continue;
      const Surface box = m.Chance(0.5) ? kWhitePlastic : Surface{"cardboard", BrightColor(m)};
      m.Block(box, {x, y + 0.02f, 0.2f}, {0.11f, m.Draw(0.1f, 0.22f), 0.15f});
    }
  }
}

/// A ring in a tall body and the table that slides into it along z.
void ImagingScanner(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.8f, 2.1f);
  const float high = m.Draw(1.8f, 1.98f);
  constexpr float kDeep = 0.7f;
  constexpr float kHole = 0.36f;
  const float middle = 0.53f * high;
  const Surface shell{"plastic", m.Chance(0.5) ? Rgb8{240, 240, 238} : Rgb8{214, 224, 230}};
  const float back = -1.1f;
  const float front = back + kDeep;
  m.Box(shell, {-half, 0, back}, {-kHole, high, front});
  m.Box(shell, {kHole, 0, back}, {half, high, front});
  m.Box(shell, {-kHole, 0, back}, {kHole, middle - kHole, front});
  m.Box(shell, {-kHole, middle + kHole, back}, {kHole, high, front});
  m.Box(kGreyPlastic, {-0.25f, middle - 0.3f, back + 0.1f}, {0.25f, middle - 0.22f, 1.1f});
  m.Box(kDark, {-0.22f, middle - 0.22f, back + 0.15f}, {0.22f, middle - 0.18f, 1.05f});
  m.Box(shell, {-0.3f, 0, front + 0.15f}, {0.3f, middle - 0.3f, 0.85f});
}

constexpr std::array kKinds = {
    FurnitureKind{"hand_rail", Placement::kOnWall, 0.0f, HandRail, 0.8f, 4.0f},
    FurnitureKind{"imaging_scanner", Placement::kFree, 0.5f, ImagingScanner},
    FurnitureKind{"iv_stand", Placement::kFree, 0.0f, IvStand},
    FurnitureKind{"medical_trolley", Placement::kFree, 0.1f, MedicalTrolley},
    FurnitureKind{"medicine_cabinet", Placement::kAgainstWall, 0.6f, MedicineCabinet, 0.6f, 1.8f},
    FurnitureKind{"monitor_stand", Placement::kFree, 0.0f, MonitorStand},
    FurnitureKind{"seat_row", Placement::kFree, 0.4f, SeatRow, 1.1f, 3.6f},
    FurnitureKind{"wheelchair", Placement::kFree, 0.0f, Wheelchair}};

}  // namespace

std::span<const FurnitureKind> Clinic() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
