// SPDX-License-Identifier: MIT

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

void Carton(PieceMaker& m, const Vec& at, const Vec& size, float yaw) {
  const Frame frame(&m, at, yaw);
  m.Block(kCardboard, {0, 0, 0}, size);
  m.Block({"paper", {206, 176, 130}}, {0, -0.0f, 0}, {0.06f, size.y() + 0.003f, size.z() + 0.005f});
  Sheet(m, kPaper, {0.27f * size.x(), 0.5f * size.y(), 0.5f * size.z() + 0.003f}, 0.1f, 0.07f);
}

void BoxStack(PieceMaker& m) {
  const float low = m.Draw(0.32f, 0.42f);
  const float middle = m.Draw(0.24f, 0.34f);
  Carton(m, {0, 0, 0.25f}, {0.55f, low, 0.42f}, m.Draw(-0.05f, 0.05f));
  const float shift = m.Draw(-0.05f, 0.05f);
  Carton(m, {shift, low, 0.25f}, {0.46f, middle, 0.36f}, m.Draw(-0.15f, 0.15f));
  if (m.Chance(0.6)) {
    const float top = m.Draw(0.18f, 0.26f);
    Carton(m, {0, low + middle, 0.25f}, {0.34f, top, 0.28f}, m.Draw(-0.3f, 0.3f));
  }
  const float beside = m.Draw(0.28f, 0.4f);
  Carton(m, {0.55f, 0, 0.24f}, {0.42f, beside, 0.38f}, m.Draw(-0.2f, 0.2f));
}

void Suitcase(PieceMaker& m) {
  const Surface shell{"plastic", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
  const float half = m.Draw(0.2f, 0.25f);
  const float top = m.Draw(0.55f, 0.7f);
  m.RoundedBox(shell, {-half, 0.05f, -0.13f}, {half, top, 0.13f}, 0.05f);
  for (const float x : {-0.6f * half, -0.2f * half, 0.2f * half, 0.6f * half}) {
    m.Box(Shaded(shell, 0.75f), {x - 0.012f, 0.12f, 0.13f}, {x + 0.012f, top - 0.08f, 0.136f});
  }
  for (const float x : {-half + 0.05f, half - 0.05f}) {
    for (const float z : {-0.09f, 0.09f})
      m.Box(kDark, {x - 0.02f, 0, z - 0.02f}, {x + 0.02f, 0.05f, z + 0.02f});
  }
  for (const float x : {-0.09f, 0.09f})
    m.Box(kSteel, {x - 0.008f, top - 0.02f, -0.1f}, {x + 0.008f, top + 0.28f, -0.085f});
  m.Box(kBlackPlastic, {-0.11f, top + 0.26f, -0.11f}, {0.11f, top + 0.29f, -0.075f});
}

void Bin(PieceMaker& m) {
  const float radius = m.Draw(0.12f, 0.16f);
  if (m.Chance(0.5)) {  // with a pedal
    const float tall = m.Draw(0.38f, 0.6f);
    m.Turn(kSteel, {0, 0.02f, 0},
           {{radius, 0.0f}, {radius, tall}, {0.9f * radius, tall + 0.05f}, {0.0f, tall + 0.07f}},
           12);
    m.Cylinder(kBlackPlastic, {0, 0, 0}, 1.03f * radius, 0.04f, 12);
    m.Cylinder(kBlackPlastic, {0, tall, 0}, 1.02f * radius, 0.025f, 12);
    m.Box(kBlackPlastic, {-0.04f, 0.0f, radius}, {0.04f, 0.02f, radius + 0.06f});
    return;
  }
  const Surface body = m.Chance(0.4) ? kWicker : Surface{"plastic", MutedColor(m)};
  m.Turn(body, {0, 0, 0},
         {{0.75f * radius, 0.0f}, {radius, 0.3f}, {0.93f * radius, 0.3f}, {0.8f * radius, 0.2f}},
         10);
  m.Turn(kDark, {0, 0.2f, 0}, {{0.8f * radius, 0.0f}, {0.0f, 0.0f}}, 10);
  for (int i = 0; i < 3; ++i) {  // crumpled paper
    const Vec at(0.4f * radius * Cos(2.1f * static_cast<float>(i)), 0.25f,
                 0.4f * radius * Sin(2.1f * static_cast<float>(i)));
    m.Ball(kPaper, at, {0.05f, 0.05f, 0.045f}, 5);
  }
}

void PetBed(PieceMaker& m) {
  const float radius = m.Draw(0.3f, 0.4f);
  const Surface outside{"wool_knit", MutedColor(m)};
  m.Turn(outside, {0, 0, 0},
         {{0.95f * radius, 0.0f},
          {radius, 0.08f},
          {0.93f * radius, 0.16f},
          {0.8f * radius, 0.15f},
          {0.72f * radius, 0.07f}},
         14);
  m.Turn(kWhiteLinen, {0, 0.07f, 0},
         {{0.73f * radius, 0.0f}, {0.5f * radius, 0.03f}, {0.0f, 0.03f}}, 14);
  if (!m.Chance(0.5)) return;
  // A cat asleep, curled up.
  static constexpr std::array<Rgb8, 3> kFurs = {Rgb8{212, 138, 66}, Rgb8{70, 66, 66},
                                                Rgb8{190, 184, 176}};
  const Surface fur{"wool_knit", m.rng().Pick(kFurs)};
  m.Ball(fur, {-0.02f, 0.15f, 0}, {0.17f, 0.08f, 0.13f}, 8);
  m.Ball(fur, {0.14f, 0.17f, 0.06f}, {0.065f, 0.06f, 0.06f}, 6);
  for (const float z : {0.03f, 0.09f}) m.Cone(fur, {0.15f, 0.21f, z}, 0.022f, 0.0f, 0.045f, 4);
  m.Bar(fur, {-0.16f, 0.12f, 0.05f}, {0.02f, 0.12f, 0.15f}, 0.022f, 5);
}

void StepLadder(PieceMaker& m) {
  const float height = m.Draw(1.2f, 1.6f);
  const Surface metal = m.Chance(0.6) ? kSteel : m.palette().wood;
  for (const float x : {-0.22f, 0.22f}) {
    m.Bar(metal, {x, 0.02f, 0.32f}, {0.8f * x, height, 0.0f}, 0.022f, 4);
    m.Bar(metal, {x, 0.02f, -0.32f}, {0.8f * x, height, 0.0f}, 0.018f, 4);
  }
  const int steps = static_cast<int>(height / 0.26f);
  for (int i = 1; i < steps; ++i) {
    const float y = 0.26f * static_cast<float>(i);
    const float z = 0.32f * (1.0f - y / height);
    m.Box(kGreyPlastic, {-0.21f, y, z - 0.06f}, {0.21f, y + 0.03f, z + 0.04f});
  }
  m.Box({"plastic", BrightColor(m)}, {-0.2f, height - 0.02f, -0.08f}, {0.2f, height + 0.03f, 0.1f});
}

/// Tall mirror that leans on the wall.
void StandingMirror(PieceMaker& m) {
  const float half = m.Draw(0.24f, 0.34f);
  const float height = m.Draw(1.55f, 1.75f);
  const Surface rim = FrameSurface(m);
  const Frame frame(&m, Turned({0, 0.005f, 0.2f}, 0.0f, -0.11f));
  m.Box(rim, {-half, 0, -0.02f}, {half, height, 0.015f});
  Sheet(m, kMirror, {0, 0.04f, 0.018f}, 2.0f * half - 0.08f, height - 0.08f);
}

void VacuumCleaner(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.08f));
  const Surface shell{"plastic", BrightColor(m)};
  m.RoundedBox(shell, {-0.14f, 0.04f, -0.2f}, {0.14f, 0.26f, 0.16f}, 0.08f);
  for (const float x : {-0.15f, 0.15f}) {
    const Frame frame(&m, Turned({x - 0.02f, 0.09f, -0.1f}, 0.0f, 0.0f, -kQuarterTurn));
    m.Cylinder(kDark, {0, 0, 0}, 0.09f, 0.04f, 10);
  }
  // The hose rises from the front and the tube leans back down to the nozzle.
  m.Bar(kDark, {0, 0.22f, 0.12f}, {0.12f, 0.6f, 0.2f}, 0.025f, 5);
  m.Bar(kDark, {0.12f, 0.6f, 0.2f}, {0.22f, 0.9f, 0.14f}, 0.025f, 5);
  m.Bar(kSteel, {0.22f, 0.95f, 0.14f}, {0.26f, 0.06f, 0.5f}, 0.018f, 5);
  m.TaperedBox(kBlackPlastic, {0.26f, 0, 0.52f}, {0.28f, 0.1f}, {0.26f, 0.05f, 0.5f},
               {0.22f, 0.06f});
}

void Bicycle(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.04f));
  const Surface paint{"painted_wood", BrightColor(m)};
  constexpr float kWheel = 0.33f;
  const Vec rear(0, kWheel, -0.5f);
  const Vec front(0, kWheel, 0.52f);
  const Vec crank(0, 0.28f, -0.06f);
  const Vec seat(0, 0.86f, -0.22f);
  const Vec head(0, 0.82f, 0.36f);
  for (const Vec& hub : {rear, front}) {
    Hoop(m, kDark, hub, kWheel - 0.016f, 0.016f, 12);
    for (int i = 0; i < 3; ++i) {
      const float angle = 2.0f / 3.0f * kQuarterTurn * static_cast<float>(i);
      const Vec spoke = (kWheel - 0.02f) * Vec(0, Sin(angle), Cos(angle));
      m.Bar(kSteel, hub - spoke, hub + spoke, 0.004f, 3);
    }
  }
  m.Bar(paint, crank, seat, 0.018f, 5);
  m.Bar(paint, crank, head - Vec(0, 0.08f, 0), 0.02f, 5);
  m.Bar(paint, seat - Vec(0, 0.1f, 0), head, 0.018f, 5);
  m.Bar(paint, rear, crank, 0.014f, 4);
  m.Bar(paint, rear, seat - Vec(0, 0.1f, 0), 0.014f, 4);
  m.Bar(paint, front, head + Vec(0, 0.08f, -0.03f), 0.016f, 5);
  m.TaperedBox(kDark, {0, 0.86f, -0.21f}, {0.06f, 0.2f}, {0, 0.92f, -0.25f}, {0.14f, 0.24f});
  m.Bar(kSteel, {-0.28f, 0.95f, 0.3f}, {0.28f, 0.95f, 0.3f}, 0.013f, 5);
  m.Bar(kSteel, head, {0, 0.95f, 0.3f}, 0.014f, 4);
  for (const float x : {-0.26f, 0.26f})
    m.Bar(kDark, {x, 0.95f, 0.3f}, {1.1f * x, 0.93f, 0.18f}, 0.018f, 5);
  m.Box(kDark, {-0.14f, 0.13f, -0.1f}, {-0.05f, 0.15f, -0.02f});
  m.Box(kDark, {0.05f, 0.41f, -0.1f}, {0.14f, 0.43f, -0.02f});
}

void Backpack(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.1f));
  const Surface cloth{"canvas", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
  const Frame frame(&m, Turned({0, 0.0f, 0.1f}, 0.0f, 0.0f));
  m.RoundedBox(cloth, {-0.16f, 0, -0.1f}, {0.16f, 0.44f, 0.08f}, 0.08f);
  m.RoundedBox(Shaded(cloth, 0.75f), {-0.12f, 0.03f, 0.07f}, {0.12f, 0.22f, 0.14f}, 0.04f);
  m.Bar(kDark, {-0.04f, 0.44f, -0.02f}, {0.04f, 0.44f, -0.02f}, 0.018f, 5);
  m.Box(kDark, {-0.16f, 0.29f, 0.081f}, {0.16f, 0.305f, 0.085f});
}

constexpr std::array kKinds = {
    FurnitureKind{"backpack", Placement::kFree, 0.0f, Backpack},
    FurnitureKind{"bicycle", Placement::kFree, 0.2f, Bicycle},
    FurnitureKind{"bin", Placement::kFree, 0.1f, Bin},
    FurnitureKind{"box_stack", Placement::kAgainstWall, 0.2f, BoxStack},
    FurnitureKind{"pet_bed", Placement::kFree, 0.2f, PetBed},
    FurnitureKind{"standing_mirror", Placement::kAgainstWall, 0.6f, StandingMirror},
    FurnitureKind{"step_ladder", Placement::kFree, 0.2f, StepLadder},
    FurnitureKind{"suitcase", Placement::kFree, 0.1f, Suitcase},
    FurnitureKind{"vacuum_cleaner", Placement::kFree, 0.2f, VacuumCleaner}};

}  // namespace

std::span<const FurnitureKind> FloorClutter() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
