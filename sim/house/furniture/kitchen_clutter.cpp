// SPDX-License-Identifier: MIT

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/kitchen_parts.h"

namespace bulletnav::sim::furniture {

void CookingPot(PieceMaker& m, const Vec& at, float radius, float height) {
  const std::array<Surface, 4> metals = {
      kSteel, {"cast_iron"}, {"white_enamel", {200, 60, 50}}, {"copper"}};
  const Surface pot = m.rng().Pick(metals);
  m.Turn(pot, at,
         {{0.92f * radius, 0.0f},
          {radius, height},
          {0.9f * radius, height + 0.005f},
          {0.25f * radius, height + 0.03f},
          {0.0f, height + 0.03f}},
         12);
  m.Cylinder(kBlackPlastic, at + Vec(0, height + 0.03f, 0), 0.02f, 0.025f, 6);
  for (const float x : {-1.0f, 1.0f}) {
    const Vec grip = at + Vec(x * (radius + 0.02f), 0.8f * height, 0);
    m.Box(kBlackPlastic, grip - Vec(0.025f, 0.008f, 0.04f), grip + Vec(0.025f, 0.008f, 0.04f));
  }
}

namespace {

void Kettle(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.07f));
  const Surface body =
      m.Chance(0.5) ? kSteel
                    : Surface{"plastic", m.Chance(0.5) ? Rgb8{240, 240, 236} : BrightColor(m)};
  m.Cylinder(kBlackPlastic, {0, 0, 0}, 0.085f, 0.02f, 10);
  m.Turn(body, {0, 0.02f, 0}, {{0.085f, 0.0f}, {0.08f, 0.08f}, {0.055f, 0.19f}, {0.0f, 0.2f}}, 10);
  m.Cylinder(kBlackPlastic, {0, 0.215f, 0}, 0.02f, 0.02f, 6);
  m.TaperedBox(body, {0.08f, 0.13f, 0}, {0.03f, 0.04f}, {0.1f, 0.2f, 0}, {0.05f, 0.03f});
  m.Bar(kBlackPlastic, {-0.06f, 0.2f, 0}, {-0.13f, 0.19f, 0}, 0.012f, 4);
  m.Bar(kBlackPlastic, {-0.13f, 0.19f, 0}, {-0.11f, 0.07f, 0}, 0.012f, 4);
}

void CoffeeMachine(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.1f));
  const Surface body = m.Chance(0.5) ? kBlackPlastic : Surface{"plastic", {176, 40, 36}};
  m.Box(body, {-0.11f, 0, -0.14f}, {0.11f, 0.05f, 0.14f});
  m.Box(body, {-0.11f, 0.05f, -0.14f}, {0.11f, 0.33f, -0.02f});
  m.Box(body, {-0.11f, 0.24f, -0.02f}, {0.11f, 0.35f, 0.13f});
  m.Box(kSteel, {-0.1f, 0.05f, -0.01f}, {0.1f, 0.06f, 0.13f});
  m.Cylinder(kSteel, {0, 0.2f, 0.06f}, 0.03f, 0.04f, 6);
  m.Cylinder(m.palette().ceramic, {0, 0.06f, 0.06f}, 0.035f, 0.07f, 8);
  Sheet(m, kSteel, {0, 0.27f, 0.133f}, 0.16f, 0.05f);
}

void Toaster(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.08f));
  const Surface body = m.Chance(0.5) ? kSteel : Surface{"white_enamel", BrightColor(m)};
  m.RoundedBox(body, {-0.15f, 0.01f, -0.09f}, {0.15f, 0.2f, 0.09f}, 0.04f);
  for (const float z : {-0.03f, 0.03f}) {
    m.Quad(kDark, {-0.1f, 0.202f, z + 0.014f}, {0.1f, 0.202f, z + 0.014f},
           {0.1f, 0.202f, z - 0.014f}, {-0.1f, 0.202f, z - 0.014f});
    m.Box({"cork", {235, 190, 130}}, {-0.07f, 0.19f, z - 0.008f}, {0.07f, 0.25f, z + 0.008f});
  }
  m.Box(kBlackPlastic, {0.15f, 0.12f, -0.025f}, {0.175f, 0.14f, 0.025f});
  m.Box(kBlackPlastic, {-0.15f, 0.0f, -0.09f}, {0.15f, 0.02f, 0.09f});
}

void Pot(PieceMaker& m) {
  const float radius = m.Draw(0.1f, 0.13f);
  CookingPot(m, {0, 0, 0}, radius, m.Draw(0.1f, 0.17f));
}

void Plates(PieceMaker& m) {
  const Surface& white = m.palette().ceramic;
  const float radius = m.Draw(0.12f, 0.14f);
  for (int i = 0; i < 3; ++i) {
    m.Turn(white, {0, 0.016f * static_cast<float>(i), 0},
           {{0.55f * radius, 0.0f}, {radius, 0.018f}, {0.6f * radius, 0.01f}, {0.0f, 0.01f}}, 12);
  }
  const Surface cup{"ceramic", MutedColor(m)};
  m.Turn(cup, {0.02f, 0.045f, 0}, {{0.03f, 0.0f}, {0.045f, 0.075f}, {0.038f, 0.07f}, {0.0f, 0.02f}},
         8);
}

void BowlOfFruit(PieceMaker& m) {
  const float radius = m.Draw(0.13f, 0.17f);
  const Surface bowl = m.Chance(0.5) ? m.palette().wood : Surface{"ceramic", MutedColor(m)};
  m.Turn(bowl, {0, 0, 0},
         {{0.45f * radius, 0.0f}, {radius, 0.08f}, {0.93f * radius, 0.08f}, {0.0f, 0.03f}}, 12);
  static constexpr std::array<Rgb8, 4> kFruits = {Rgb8{214, 48, 40}, Rgb8{240, 150, 40},
                                                  Rgb8{150, 190, 60}, Rgb8{246, 214, 70}};
  for (int i = 0; i < 6; ++i) {
    const float angle = 1.26f * static_cast<float>(i);
    const float out = i == 5 ? 0.0f : 0.55f * radius;
    const Surface fruit{"painted_wood", kFruits[static_cast<std::size_t>(i) % kFruits.size()]};
    m.Ball(fruit, {out * Cos(angle), i == 5 ? 0.14f : 0.085f, out * Sin(angle)},
           {0.042f, 0.04f, 0.042f}, 6);
  }
}

void Bottles(PieceMaker& m) {
  static constexpr std::array<Rgb8, 4> kGlasses = {Rgb8{50, 90, 55}, Rgb8{110, 40, 40},
                                                   Rgb8{190, 150, 70}, Rgb8{60, 60, 70}};
  for (int i = 0; i < 3; ++i) {
    const Vec at(0.09f * static_cast<float>(i - 1), 0, i == 1 ? -0.04f : 0.03f);
    const float tall = m.Draw(0.24f, 0.32f);
    m.Turn({"glass", m.rng().Pick(kGlasses)}, at,
           {{0.036f, 0.0f},
            {0.036f, 0.6f * tall},
            {0.013f, 0.78f * tall},
            {0.013f, tall},
            {0.0f, tall}},
           8);
    m.Turn(kPaper, at, {{0.0375f, 0.2f * tall}, {0.0375f, 0.45f * tall}}, 8);
  }
}

void KnifeBlock(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.1f));
  {
    const Frame frame(&m, Turned({0, 0.03f, 0}, 0.0f, -0.45f));
    m.Box(m.palette().wood, {-0.06f, 0.0f, -0.05f}, {0.06f, 0.2f, 0.06f});
    for (int i = 0; i < 5; ++i) {
      const float x = -0.04f + 0.04f * static_cast<float>(i % 3);
      const float z = i < 3 ? -0.02f : 0.03f;
      m.Box(kBlackPlastic, {x - 0.009f, 0.2f, z - 0.012f}, {x + 0.009f, 0.29f, z + 0.012f});
    }
  }
  m.Box(m.palette().wood, {-0.06f, 0, -0.06f}, {0.06f, 0.04f, 0.07f});
}

void CuttingBoard(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.15f));
  m.Box(m.palette().wood, {-0.19f, 0, -0.13f}, {0.19f, 0.022f, 0.13f});
  m.Turn({"painted_wood", {224, 176, 112}}, {-0.06f, 0.022f, 0},
         {{0.07f, 0.0f}, {0.09f, 0.04f}, {0.05f, 0.085f}, {0.0f, 0.09f}}, 8);
  m.Box(kSteel, {0.04f, 0.022f, -0.02f}, {0.17f, 0.026f, 0.02f});
  m.Box(kBlackPlastic, {0.05f, 0.022f, -0.11f}, {0.07f, 0.037f, -0.02f});
}

void Microwave(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.07f));
  MicrowaveOven(m, {0, 0, -0.18f});
}

/// Places laid for two, across a table.
void TableSetting(PieceMaker& m) {
  const Surface mat = m.Chance(0.5) ? m.palette().other_accent : Surface{"linen", MutedColor(m)};
  const Surface& white = m.palette().ceramic;
  m.Box(mat, {-0.22f, 0, -0.15f}, {0.22f, 0.004f, 0.15f});
  m.Turn(white, {0, 0.004f, 0}, {{0.07f, 0.0f}, {0.125f, 0.018f}, {0.08f, 0.01f}, {0.0f, 0.01f}},
         12);
  m.Box(kSteel, {-0.17f, 0.004f, -0.09f}, {-0.155f, 0.01f, 0.09f});
  m.Box(kSteel, {0.155f, 0.004f, -0.09f}, {0.17f, 0.01f, 0.09f});
  m.Turn({"glass", {205, 225, 235}}, {0.16f, 0.004f, -0.11f},
         {{0.03f, 0.0f}, {0.036f, 0.11f}, {0.03f, 0.11f}, {0.0f, 0.02f}}, 8);
}

constexpr std::array kKinds = {
    FurnitureKind{"bottles", Placement::kOnTop, 0.0f, Bottles},
    FurnitureKind{"bowl_of_fruit", Placement::kOnTop, 0.0f, BowlOfFruit},
    FurnitureKind{"coffee_machine", Placement::kOnTop, 0.0f, CoffeeMachine},
    FurnitureKind{"cutting_board", Placement::kOnTop, 0.0f, CuttingBoard},
    FurnitureKind{"kettle", Placement::kOnTop, 0.0f, Kettle},
    FurnitureKind{"knife_block", Placement::kOnTop, 0.0f, KnifeBlock},
    FurnitureKind{"microwave", Placement::kOnTop, 0.0f, Microwave},
    FurnitureKind{"plates", Placement::kOnTop, 0.0f, Plates},
    FurnitureKind{"pot", Placement::kOnTop, 0.0f, Pot},
    FurnitureKind{"table_setting", Placement::kOnTop, 0.0f, TableSetting},
    FurnitureKind{"toaster", Placement::kOnTop, 0.0f, Toaster}};

}  // namespace

std::span<const FurnitureKind> KitchenClutter() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
