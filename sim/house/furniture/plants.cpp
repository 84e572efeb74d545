// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kGolden = 2.39996f;  // angle between one leaf and the next

Surface Foliage(PieceMaker& m) {
  static constexpr std::array<Rgb8, 4> kGreens = {Rgb8{255, 255, 255}, Rgb8{200, 225, 190},
                                                  Rgb8{235, 255, 200}, Rgb8{190, 215, 205}};
  return {"leaves", m.rng().Pick(kGreens)};
}

Vec Around(float angle, float out, float up) {
  return {out * Cos(angle), up, out * Sin(angle)};
}

/// Pot standing on the floor; its soil is at the height returned.
float Pot(PieceMaker& m, float radius, float height) {
  const std::array<Surface, 5> pots = {Surface{"ceramic", MutedColor(m)},
                                       Surface{"terracotta_tile", {255, 235, 220}}, kWicker,
                                       Surface{"ceramic", {240, 238, 232}}, Surface{"concrete"}};
  const Surface pot = m.rng().Pick(pots);
  const float narrow = m.Draw(0.65f, 1.0f);
  m.Turn(pot, {0, 0, 0},
         {{narrow * radius, 0.0f},
          {radius, height},
          {0.86f * radius, height},
          {0.84f * radius, 0.85f * height}},
         10);
  Disc(m, kSoil, {0, 0.86f * height, 0}, 0.85f * radius, 10);
  return 0.86f * height;
}

/// A round bush of leaves.
void Bush(PieceMaker& m, const Surface& leaves, const Vec& centre, float radius, int count) {
  for (int i = 0; i < count; ++i) {
    const float rise = 1.0f - 1.5f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float level = std::sqrt(std::max(0.0f, 1.0f - rise * rise));
    const Vec out = Around(kGolden * static_cast<float>(i), level, rise);
    // Never level: seen from the side it would be a line.
    const Vec along =
        m.Draw(0.6f, 0.75f) * radius * Vec(out.x(), rise > 0.45f ? 0.85f : -0.5f, out.z());
    Leaf(m, i % 3 == 0 ? Shaded(leaves, 0.75f) : leaves, centre + 0.35f * radius * out, along,
         0.65f * radius);
  }
}

/// A trunk with big leaves up its upper half: rubber tree, fiddle-leaf fig.
void FigTree(PieceMaker& m, float soil) {
  const float height = m.Draw(1.3f, 1.8f);
  const Surface leaves = Foliage(m);
  const Surface bark{"weathered_wood", {160, 130, 105}};
  m.Bar(bark, {0, soil, 0}, {0.04f, height - 0.15f, 0.03f}, 0.022f, 5);
  for (int i = 0; i < 44; ++i) {
    const float part = static_cast<float>(i) / 44.0f;
    const float y = soil + (0.35f + 0.62f * part) * (height - soil);
    const float reach = 0.34f - 0.14f * part;
    const Vec along = Around(kGolden * static_cast<float>(i), reach,
                             (i % 2 == 0 ? 0.2f : -0.22f) * m.Draw(0.6f, 1.0f));
    Leaf(m, i % 3 == 0 ? Shaded(leaves, 0.75f) : leaves, {0.02f, y, 0.02f}, along,
         m.Draw(0.17f, 0.23f));
  }
}

/// One frond that bends over: rachis of three pieces with leaflets on both sides.
void Frond(PieceMaker& m, const Surface& leaves, const Vec& base, float angle, float length) {
  Vec at = base;
  constexpr int kPieces = 5;
  for (int i = 0; i < kPieces; ++i) {
    const float slope = 1.3f - 0.5f * static_cast<float>(i);
    const Vec step = length / kPieces * Around(angle, Cos(slope), Sin(slope));
    const Vec next = at + step;
    const float wide = 0.3f * length * (1.0f - 0.15f * static_cast<float>(i));
    for (const float side : {-1.0f, 1.0f}) {
      const Vec across = Around(angle + side * 1.25f, 0.55f * wide, -0.4f * wide) + 0.6f * step;
      m.Triangle(side > 0 ? leaves : Shaded(leaves, 0.8f), at, side > 0 ? at + across : next,
                 side > 0 ? next : at + across);
    }
    at = next;
  }
}

void Palm(PieceMaker& m, float soil) {
  const Surface leaves = Foliage(m);
  const float height = m.Draw(0.12f, 0.5f);
  m.Cone({"weathered_wood", {170, 140, 110}}, {0, soil, 0}, 0.055f, 0.035f, height, 6);
  const int fronds = m.Between(13, 16);
  for (int i = 0; i < fronds; ++i) {
    Frond(m, leaves, {0, soil + height - 0.02f, 0}, kGolden * static_cast<float>(i),
          m.Draw(0.75f, 1.15f));
  }
}

/// Stiff upright blades.
void SnakePlant(PieceMaker& m, float soil, float height) {
  for (int i = 0; i < 14; ++i) {
    const float out = 0.025f * std::sqrt(static_cast<float>(i));
    const Vec base = Around(kGolden * static_cast<float>(i), out, soil - 0.01f);
    const Vec2 reach = m.Draw(Vec2(0.05f, 0.6f * height), Vec2(0.16f, height));
    const Vec along = Around(kGolden * static_cast<float>(i), reach.x(), reach.y());
    const Surface blade{"leaves", i % 2 == 0 ? Rgb8{215, 235, 175} : Rgb8{160, 190, 150}};
    Leaf(m, blade, base, along, 0.1f);
  }
}

/// Broad leaves on long stalks.
void Monstera(PieceMaker& m, float soil) {
  const Surface leaves = Foliage(m);
  for (int i = 0; i < 15; ++i) {
    const float angle = kGolden * static_cast<float>(i);
    const float rise = m.Draw(0.25f, 0.85f);
    const Vec tip = Around(angle, 0.42f - 0.25f * rise, soil + rise);
    m.Bar(Shaded(leaves, 0.7f), {0, soil, 0}, tip, 0.01f, 3);
    const Vec along = Around(angle, 0.2f, -0.2f);
    Leaf(m, i % 3 == 0 ? Shaded(leaves, 0.75f) : leaves, tip - 0.25f * along, along, 0.32f);
    for (const float side : {-1.0f, 1.0f}) {
      Leaf(m, leaves, tip, 0.7f * Around(angle + side, 0.2f, -0.1f), 0.16f);
    }
  }
}

void Cactus(PieceMaker& m, float soil) {
  const Surface green{"leaves", {170, 210, 160}};
  const float height = m.Draw(0.7f, 1.1f);
  const auto column = [&](const Vec& at, float radius, float tall) {
    m.Turn(green, at,
           {{radius, 0.0f},
            {radius, tall - radius},
            {0.7f * radius, tall - 0.3f * radius},
            {0.0f, tall}},
           8);
  };
  column({0, soil, 0}, 0.085f, height);
  for (const float side : {-1.0f, 1.0f}) {
    const float y = soil + m.Draw(0.3f, 0.55f) * height;
    m.Bar(green, {0, y, 0}, {0.2f * side, y + 0.02f, 0}, 0.055f, 7);
    column({0.2f * side, y - 0.03f, 0}, 0.058f, m.Draw(0.25f, 0.4f));
  }
}

void TallPlant(PieceMaker& m) {
  const Vec2 pot = m.Draw(Vec2(0.16f, 0.3f), Vec2(0.21f, 0.4f));
  const float soil = Pot(m, pot.x(), pot.y());
  switch (m.Below(5)) {
    case 0:
      return FigTree(m, soil);
    case 1:
      return Palm(m, soil);
    case 2:
      return SnakePlant(m, soil, m.Draw(0.75f, 1.0f));
    case 3:
      return Monstera(m, soil);
    case 4:
      return Cactus(m, soil);
  }
}

void PottedPlant(PieceMaker& m) {
  const float radius = m.Draw(0.11f, 0.15f);
  const float soil = Pot(m, radius, m.Draw(0.2f, 0.28f));
  if (m.Chance(0.3)) return SnakePlant(m, soil, m.Draw(0.4f, 0.55f));
  Bush(m, Foliage(m), {0, soil + 1.2f * radius, 0}, 2.0f * radius, 34);
}

/// For sills, tables and shelves.
void SmallPlant(PieceMaker& m) {
  const float radius = m.Draw(0.055f, 0.075f);
  const float soil = Pot(m, radius, m.Draw(0.09f, 0.13f));
  if (m.Chance(0.3)) {  // flowers
    const Surface petals{"painted_wood", BrightColor(m)};
    Bush(m, Foliage(m), {0, soil + radius, 0}, 1.7f * radius, 14);
    for (int i = 0; i < 5; ++i) {
      const Vec head = Around(kGolden * static_cast<float>(i), radius, soil + 2.2f * radius);
      m.Ball(petals, head, {0.024f, 0.02f, 0.024f}, 5);
    }
    return;
  }
  Bush(m, Foliage(m), {0, soil + 1.1f * radius, 0}, 2.0f * radius, 20);
}

/// Pot in a sling from the ceiling with tendrils over its rim.
void HangingPlant(PieceMaker& m) {
  const float drop = m.Draw(0.6f, 0.85f);
  const float radius = m.Draw(0.11f, 0.14f);
  const Surface leaves = Foliage(m);
  const Vec pot(0, -drop - 0.18f, 0);
  m.Turn({"ceramic", MutedColor(m)}, pot,
         {{0.0f, 0.0f}, {0.7f * radius, 0.02f}, {radius, 0.18f}, {0.0f, 0.16f}}, 10);
  for (int i = 0; i < 3; ++i) {
    const float angle = 4.0f / 3.0f * kQuarterTurn * static_cast<float>(i);
    m.Bar(kPaper, Around(angle, radius, -drop), {0, -0.1f, 0}, 0.006f, 3);
  }
  m.Bar(kPaper, {0, -0.12f, 0}, {0, 0, 0}, 0.008f, 3);
  Bush(m, leaves, {0, -drop + 0.02f, 0}, 1.5f * radius, 16);
  for (int i = 0; i < 7; ++i) {
    const float angle = kGolden * static_cast<float>(i);
    const float length = m.Draw(0.2f, 0.5f);
    for (const float y : Spaced(0.0f, length, 0.08f)) {
      const Vec at = Around(angle, 1.08f * radius + 0.05f * y, -drop - y);
      Leaf(m, leaves, at, Around(angle + 6.0f * y, 0.05f, -0.08f), 0.08f);
    }
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"hanging_plant", Placement::kCeiling, 0.0f, HangingPlant},
    FurnitureKind{"potted_plant", Placement::kFree, 0.1f, PottedPlant},
    FurnitureKind{"small_plant", Placement::kOnTop, 0.0f, SmallPlant},
    FurnitureKind{"tall_plant", Placement::kFree, 0.1f, TallPlant}};

}  // namespace

std::span<const FurnitureKind> Plants() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
