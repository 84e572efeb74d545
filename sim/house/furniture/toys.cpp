// SPDX-License-Identifier: MIT

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

void Bear(PieceMaker& m, const Vec& at, float size) {
  const std::array<Rgb8, 4> furs = {Rgb8{170, 112, 62}, Rgb8{222, 190, 140}, Rgb8{120, 80, 56},
                                    Rgb8{236, 226, 214}};
  const Surface fur{"wool_knit", m.rng().Pick(furs)};
  const Surface light = Shaded(fur, 1.35f);
  const Frame frame(&m, Turned(at, 0.0f) * Eigen::Scaling(size));
  m.Ball(fur, {0, 0.24f, 0}, {0.22f, 0.24f, 0.2f}, 8);
  m.Ball(fur, {0, 0.6f, 0.02f}, {0.19f, 0.18f, 0.17f}, 8);
  m.Ball(light, {0, 0.55f, 0.17f}, {0.09f, 0.07f, 0.06f}, 6);
  m.Ball(light, {0, 0.25f, 0.09f}, {0.15f, 0.17f, 0.14f}, 6);
  for (const float x : {-1.0f, 1.0f}) {
    m.Ball(fur, {0.15f * x, 0.76f, 0}, {0.07f, 0.07f, 0.04f}, 6);
    m.Ball(fur, {0.24f * x, 0.36f, 0.06f}, {0.08f, 0.14f, 0.09f}, 6);
    m.Ball(fur, {0.16f * x, 0.09f, 0.22f}, {0.09f, 0.09f, 0.17f}, 6);
    m.Block(kDark, {0.07f * x, 0.63f, 0.185f}, {0.035f, 0.035f, 0.02f});
  }
  m.Block(kDark, {0, 0.57f, 0.23f}, {0.05f, 0.035f, 0.02f});
}

void TeddyBear(PieceMaker& m) {
  Bear(m, {0, 0, 0}, m.Draw(0.4f, 0.75f));
}

void ToyChest(PieceMaker& m) {
  const Surface body = m.Chance(0.5) ? Surface{"painted_wood", BrightColor(m)} : m.palette().wood;
  const float half = m.Draw(0.36f, 0.46f);
  constexpr float kDepth = 0.42f;
  constexpr float kTop = 0.44f;
  m.Box(body, {-half, 0.03f, 0}, {half, kTop - 0.08f, kDepth});
  for (const float x : {-half, half - 0.025f})
    m.Box(body, {x, kTop - 0.08f, 0}, {x + 0.025f, kTop, kDepth});
  m.Box(body, {-half + 0.025f, kTop - 0.08f, kDepth - 0.025f}, {half - 0.025f, kTop, kDepth});
  for (const float x : {-half + 0.03f, half - 0.09f})
    m.Box(body, {x, 0, 0.03f}, {x + 0.06f, 0.03f, kDepth - 0.03f});
  {  // a star on the front: two squares
    const Surface star{"painted_wood", {250, 240, 200}};
    for (const float turn : {0.0f, 0.785f}) {
      const Frame frame(&m, Turned({0, 0.22f, kDepth + 0.003f + 0.002f * turn}, 0.0f, 0.0f, turn));
      m.Quad(star, {-0.07f, -0.07f, 0}, {0.07f, -0.07f, 0}, {0.07f, 0.07f, 0}, {-0.07f, 0.07f, 0});
    }
  }
  {  // the lid, up
    const Frame frame(&m, Turned({0, kTop, 0.02f}, 0.0f, -0.0f));
    m.Box(Shaded(body, 0.85f), {-half, 0, 0}, {half, 0.36f, 0.03f});
  }
  Bear(m, {-0.45f * half, kTop - 0.1f, 0.24f}, 0.42f);
  m.Ball({"plastic", BrightColor(m)}, {0.3f * half, kTop + 0.01f, 0.24f}, {0.11f, 0.11f, 0.11f}, 8);
  for (int i = 0; i < 3; ++i) {
    const Vec2 at = m.Draw(Vec2(0.2f * half, 0.12f), Vec2(0.8f * half, 0.34f));
    const Frame frame(&m, Turned({at.x(), kTop - 0.06f, at.y()}, m.Draw(0.0f, 3.0f), 0.4f));
    m.Block({"painted_wood", BrightColor(m)}, {0, 0, 0}, {0.1f, 0.1f, 0.1f});
  }
}

void Dollhouse(PieceMaker& m) {
  const Surface walls{"painted_wood", m.Chance(0.5) ? Rgb8{250, 214, 222} : Rgb8{214, 232, 240}};
  const Surface roof{"painted_wood", BrightColor(m)};
  constexpr float kHalf = 0.36f;
  constexpr float kDepth = 0.3f;
  constexpr float kEaves = 0.62f;
  OpenBody(m, walls, {-kHalf, 0, 0}, {kHalf, kEaves, kDepth}, 0.02f);
  m.Box(walls, {-kHalf + 0.02f, 0.3f, 0.01f}, {kHalf - 0.02f, 0.32f, kDepth - 0.005f});
  m.Box(walls, {-0.01f, 0.02f, 0.01f}, {0.01f, kEaves - 0.02f, kDepth - 0.005f});
  const std::array<std::array<float, 2>, 4> rooms = {
      {{-0.18f, 0.02f}, {0.18f, 0.02f}, {-0.18f, 0.32f}, {0.18f, 0.32f}}};
  for (const auto& [x, y] : rooms) {
    Sheet(m, {"polka_wallpaper", BrightColor(m)}, {x, y, 0.013f}, 0.32f, 0.28f);
    const Surface paint{"painted_wood", BrightColor(m)};
    const float shift = m.Draw(-0.06f, 0.06f);
    const Vec2 size = m.Draw(Vec2(0.08f, 0.07f), Vec2(0.16f, 0.15f));
    m.Block(paint, {x + shift, y, 0.14f}, {size.x(), size.y(), 0.1f});
  }
  // The roof: gable and two slopes that overhang.
  const float ridge = kEaves + 0.26f;
  m.Triangle(walls, {-kHalf, kEaves, kDepth - 0.01f}, {kHalf, kEaves, kDepth - 0.01f},
             {0, ridge, kDepth - 0.01f});
  for (const float side : {-1.0f, 1.0f}) {
    const Frame frame(&m, Turned({0, ridge + 0.015f, 0}, 0.0f, 0.0f, side > 0 ? -0.62f : 0.62f));
    const float reach = 0.52f;
    m.Box(roof, {side > 0 ? 0.0f : -reach, -0.02f, 0},
          {side > 0 ? reach : 0.0f, 0.01f, kDepth + 0.03f});
  }
  m.Block(roof, {0.18f, ridge - 0.12f, 0.12f}, {0.07f, 0.18f, 0.07f});
}

void RockingHorse(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.1f));
  const Surface& wood = m.palette().wood;
  const Surface saddle{"painted_wood", BrightColor(m)};
  for (const float x : {-0.13f, 0.13f}) {  // bows
    Vec last(x, 0.13f, -0.45f);
    for (int i = 1; i <= 4; ++i) {
      const float z = -0.45f + 0.225f * static_cast<float>(i);
      const Vec next(x, 0.02f + 0.5f * z * z, z);
      m.Bar(wood, last, next, 0.02f, 4);
      last = next;
    }
    for (const float z : {-0.2f, 0.2f})
      m.Bar(wood, {x, 0.04f, 1.3f * z}, {0.6f * x, 0.42f, z}, 0.025f, 5);
  }
  m.Ball(wood, {0, 0.47f, 0}, {0.12f, 0.13f, 0.29f}, 8);
  m.Box(saddle, {-0.125f, 0.5f, -0.12f}, {0.125f, 0.61f, 0.1f});
  m.TaperedBox(wood, {0, 0.5f, 0.2f}, {0.1f, 0.16f}, {0, 0.8f, 0.31f}, {0.08f, 0.11f});
  m.TaperedBox(wood, {0, 0.68f, 0.44f}, {0.07f, 0.09f}, {0, 0.84f, 0.3f}, {0.09f, 0.14f});
  for (const float x : {-0.03f, 0.03f}) m.Block(wood, {x, 0.83f, 0.27f}, {0.02f, 0.06f, 0.03f});
  m.TaperedBox({"wool_knit", {90, 60, 40}}, {0, 0.52f, 0.13f}, {0.03f, 0.05f}, {0, 0.87f, 0.24f},
               {0.03f, 0.06f});
  m.Bar({"wool_knit", {90, 60, 40}}, {0, 0.52f, -0.26f}, {0, 0.3f, -0.36f}, 0.03f, 5);
  m.Bar(saddle, {-0.14f, 0.7f, 0.3f}, {0.14f, 0.7f, 0.3f}, 0.014f, 5);
}

void ToyBlocks(PieceMaker& m) {
  constexpr float kSide = 0.055f;
  for (int i = 0; i < 6; ++i) {
    const int row = i < 3 ? 0 : (i < 5 ? 1 : 2);
    const int place = i < 3 ? i : (i < 5 ? i - 3 : 0);
    const float x =
        (static_cast<float>(place) + 0.5f * static_cast<float>(row) - 1.0f) * (kSide + 0.008f);
    const Frame frame(&m, {x, kSide * static_cast<float>(row), 0}, m.Draw(-0.2f, 0.2f));
    m.Block({"painted_wood", BrightColor(m)}, {0, 0, 0}, {kSide, kSide, kSide});
  }
  const Frame frame(&m, {0.04f, 0, 0.09f}, 0.7f);
  m.Block({"painted_wood", BrightColor(m)}, {0, 0, 0}, {kSide, kSide, kSide});
}

void Ball(PieceMaker& m) {
  const float radius = m.Draw(0.09f, 0.16f);
  const Vec centre(0, radius, 0);
  const Surface first{"plastic", BrightColor(m)};
  const Surface second = m.Chance(0.5) ? kWhitePlastic : Surface{"plastic", BrightColor(m)};
  // Segments from pole to pole in turn, the axis leaning.
  const Frame frame(&m, Turned(centre, 0.4f, 0.5f, 0.4f));
  constexpr int kSegments = 8;
  constexpr int kBands = 5;
  const auto point = [&](int segment, int band) {
    const float around = 4.0f * kQuarterTurn * static_cast<float>(segment) / kSegments;
    const float down = 2.0f * kQuarterTurn * static_cast<float>(band) / kBands;
    return Vec(radius * Vec(Sin(down) * Cos(around), -Cos(down), -Sin(down) * Sin(around)));
  };
  for (int s = 0; s < kSegments; ++s) {
    for (int b = 0; b < kBands; ++b) {
      m.Quad(s % 2 == 0 ? first : second, point(s, b), point(s + 1, b), point(s + 1, b + 1),
             point(s, b + 1));
    }
  }
}

constexpr std::array kKinds = {FurnitureKind{"ball", Placement::kFree, 0.0f, Ball},
                               FurnitureKind{"dollhouse", Placement::kAgainstWall, 0.4f, Dollhouse},
                               FurnitureKind{"rocking_horse", Placement::kFree, 0.3f, RockingHorse},
                               FurnitureKind{"teddy_bear", Placement::kOnTop, 0.0f, TeddyBear},
                               FurnitureKind{"toy_blocks", Placement::kOnTop, 0.0f, ToyBlocks},
                               FurnitureKind{"toy_chest", Placement::kAgainstWall, 0.5f, ToyChest}};

}  // namespace

std::span<const FurnitureKind> Toys() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
