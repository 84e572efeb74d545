// SPDX-License-Identifier: MIT

#include "sim/base/elementary.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

void BooksPile(PieceMaker& m) {
  float y = 0.0f;
  const int count = m.Between(3, 5);
  for (int i = 0; i < count; ++i) {
    const Frame frame(&m, {0, y, 0}, m.Draw(-0.35f, 0.35f));
    const Vec2 half = m.Draw(Vec2(0.1f, 0.075f), Vec2(0.14f, 0.1f));
    const float tall = m.Draw(0.025f, 0.045f);
    const Surface cover{"paper", MutedColor(m)};
    m.Box(cover, {-half.x(), 0, -half.y()}, {half.x(), tall, half.y()});
    m.Box(kPaper, {half.x() - 0.004f, 0.005f, -half.y() + 0.008f},
          {half.x() + 0.001f, tall - 0.005f, half.y() - 0.008f});
    y += tall;
  }
}

void Vase(PieceMaker& m) {
  const float tall = m.Draw(0.18f, 0.28f);
  m.Turn({"ceramic", MutedColor(m)}, {0, 0, 0},
         {{0.05f, 0.0f},
          {0.085f, 0.4f * tall},
          {0.04f, 0.85f * tall},
          {0.055f, tall},
          {0.0f, 0.9f * tall}},
         10);
  const Surface petals{"painted_wood", BrightColor(m)};
  for (int i = 0; i < 5; ++i) {
    const float angle = 2.4f * static_cast<float>(i);
    const float out = 0.03f + 0.022f * static_cast<float>(i);
    const Vec head(out * Cos(angle), tall + 0.24f - out, out * Sin(angle));
    m.Bar(kLeaves, {0, 0.9f * tall, 0}, head, 0.005f, 3);
    m.Ball(petals, head, {0.036f, 0.03f, 0.036f}, 5);
    Leaf(m, kLeaves, {0, tall, 0}, 0.6f * (head - Vec(0, tall, 0)) + Vec(0.02f, 0.04f, 0.02f),
         0.06f);
  }
}

void Laptop(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.08f));
  const Surface shell = m.Chance(0.6) ? kSteel : kBlackPlastic;
  m.Box(shell, {-0.16f, 0, -0.11f}, {0.16f, 0.016f, 0.11f});
  m.Picture({"keyboard"}, {-0.14f, 0.018f, 0.03f}, {0.14f, 0.018f, 0.03f}, {0.14f, 0.018f, -0.09f},
            {-0.14f, 0.018f, -0.09f});
  const Frame frame(&m, Turned({0, 0.016f, -0.11f}, 0.0f, -0.3f));
  m.Box(shell, {-0.16f, 0, -0.006f}, {0.16f, 0.215f, 0.004f});
  Sheet(m, {"computer_screen"}, {0, 0.012f, 0.007f}, 0.296f, 0.19f);
}

void Candles(PieceMaker& m) {
  const Surface wax{"paper", m.Chance(0.5) ? Rgb8{250, 244, 226} : MutedColor(m)};
  m.Box(m.palette().wood, {-0.13f, 0, -0.05f}, {0.13f, 0.012f, 0.05f});
  for (int i = 0; i < 3; ++i) {
    const float x = 0.08f * static_cast<float>(i - 1);
    const float tall = m.Draw(0.08f, 0.2f);
    m.Cylinder(wax, {x, 0.012f, 0}, 0.028f, tall, 8);
    m.SetGlow(Glow::kLamp);
    m.Cone({"lamp_shade", {255, 200, 90}}, {x, 0.014f + tall, 0}, 0.009f, 0.0f, 0.03f, 4);
    m.SetGlow(Glow::kNone);
  }
}

void StandingFrame(PieceMaker& m) {
  const Surface rim = FrameSurface(m);
  const Vec2 size = m.Chance(0.5) ? Vec2(0.16f, 0.22f) : Vec2(0.24f, 0.18f);
  const Frame frame(&m, Turned({0, 0.003f, 0.03f}, 0.0f, -0.2f));
  Panel(m, rim, {-0.5f * size.x(), 0, -0.01f}, {0.5f * size.x(), size.y(), 0.01f});
  FamilyPhoto(m, {0, 0.022f, 0.012f}, size.x() - 0.044f, size.y() - 0.044f);
  m.Quad(rim, {0.5f * size.x(), 0, -0.01f}, {-0.5f * size.x(), 0, -0.01f},
         {-0.5f * size.x(), size.y(), -0.01f}, {0.5f * size.x(), size.y(), -0.01f});
}

/// The map of the world on a ball.
void MapBall(PieceMaker& m, const Vec& centre, float radius) {
  constexpr int kAround = 10;
  constexpr int kBands = 6;
  const auto point = [&](int i, int band) {
    const float around = 4.0f * kQuarterTurn * static_cast<float>(i) / kAround;
    const float down = 2.0f * kQuarterTurn * static_cast<float>(band) / kBands;
    const float out = Sin(down);
    return Vec(centre + radius * Vec(out * Cos(around), -Cos(down), -out * Sin(around)));
  };
  for (int i = 0; i < kAround; ++i) {
    for (int band = 0; band < kBands; ++band) {
      const Vec2 cell(1.0f / kAround, 1.0f / kBands);
      const Vec2 low = cell.cwiseProduct(Vec2(static_cast<float>(i), static_cast<float>(band)));
      m.Picture({"world_map"}, point(i, band), point(i + 1, band), point(i + 1, band + 1),
                point(i, band + 1), {low, low + cell});
    }
  }
}

void Globe(PieceMaker& m) {
  const float scale = m.Draw(0.85f, 1.1f);
  const Frame size(&m, Eigen::Affine3f(Eigen::Scaling(scale)));
  m.Turn(m.palette().wood, {0, 0, 0},
         {{0.09f, 0.0f}, {0.08f, 0.02f}, {0.015f, 0.05f}, {0.015f, 0.1f}}, 8);
  MapBall(m, {0, 0.22f, 0}, 0.13f);
  const Frame frame(&m, Turned({0, 0.22f, 0}, 0.4f));
  for (int i = 0; i < 6; ++i) {
    const auto point = [](int k) {
      const float angle = 0.5f * static_cast<float>(k) - 1.9f;
      return Vec(0.145f * Cos(angle), 0.145f * Sin(angle), 0);
    };
    m.Bar(kBrass, point(i), point(i + 1), 0.008f, 4);
  }
}

void Radio(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.12f));
  const Surface body = m.Chance(0.5) ? m.palette().wood : Surface{"plastic", BrightColor(m)};
  m.RoundedBox(body, {-0.16f, 0, -0.06f}, {0.16f, 0.18f, 0.06f}, 0.025f);
  {
    const Frame frame(&m, Turned({-0.07f, 0.085f, 0.06f}, 0.0f, kQuarterTurn));
    m.Cylinder(kDark, {0, 0, 0}, 0.058f, 0.006f, 12);
  }
  Sheet(m, {"paper", {240, 225, 180}}, {0.075f, 0.09f, 0.063f}, 0.1f, 0.05f);
  for (const float x : {0.045f, 0.105f}) {
    const Frame frame(&m, Turned({x, 0.045f, 0.06f}, 0.0f, kQuarterTurn));
    m.Cylinder(kSteel, {0, 0, 0}, 0.018f, 0.02f, 6);
  }
  m.Bar(kSteel, {0.13f, 0.17f, -0.03f}, {0.2f, 0.38f, -0.03f}, 0.005f, 3);
}

void Aquarium(PieceMaker& m) {
  const Surface water{"glass", {120, 190, 215}};
  m.Box(water, {-0.3f, 0.05f, -0.15f}, {0.3f, 0.34f, 0.15f});
  m.Box(kBlackPlastic, {-0.305f, 0.34f, -0.155f}, {0.305f, 0.4f, 0.155f});
  m.Box({"soil", {235, 215, 180}}, {-0.305f, 0, -0.155f}, {0.305f, 0.06f, 0.155f});
  for (const float x : {-0.2f, -0.14f, 0.18f, 0.22f}) {
    Leaf(m, kLeaves, {x, 0.06f, 0.153f}, {m.Draw(-0.03f, 0.03f), m.Draw(0.12f, 0.22f), 0.001f},
         0.05f);
  }
  for (int i = 0; i < 3; ++i) {
    const Vec2 place = m.Draw(Vec2(-0.22f, 0.14f), Vec2(0.22f, 0.28f));
    const Vec at(place.x(), place.y(), 0.153f);
    m.Quad({"plastic", {250, 140, 50}}, at + Vec(-0.035f, 0, 0), at + Vec(0, -0.016f, 0),
           at + Vec(0.025f, 0, 0), at + Vec(0, 0.016f, 0));
    m.Triangle({"plastic", {250, 140, 50}}, at + Vec(0.05f, -0.016f, 0), at + Vec(0.05f, 0.016f, 0),
               at + Vec(0.02f, 0, 0));
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"aquarium", Placement::kOnTop, 0.0f, Aquarium},
    FurnitureKind{"books_pile", Placement::kOnTop, 0.0f, BooksPile},
    FurnitureKind{"candles", Placement::kOnTop, 0.0f, Candles},
    FurnitureKind{"globe", Placement::kOnTop, 0.0f, Globe},
    FurnitureKind{"laptop", Placement::kOnTop, 0.0f, Laptop},
    FurnitureKind{"picture_frame", Placement::kOnTop, 0.0f, StandingFrame},
    FurnitureKind{"radio", Placement::kOnTop, 0.0f, Radio},
    FurnitureKind{"vase", Placement::kOnTop, 0.0f, Vase}};

}  // namespace

std::span<const FurnitureKind> HomeClutter() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
