// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

void PianoKeys(PieceMaker& m, float half, float y, float z) {
  const Surface ivory{"plastic", {248, 246, 238}};
  m.Box(ivory, {-half, y, z}, {half, y + 0.02f, z + 0.15f});
  // Black keys in groups of two and three.
  const float pitch = 2.0f * half / 36.0f;
  for (int i = 1; i < 36; ++i) {
    const int step = i % 7;
    if (step == 0 || step == 3) continue;
    const float x = -half + pitch * static_cast<float>(i);
    const float up = y + 0.03f;
    m.Quad(kDark, {x - 0.011f, up, z + 0.095f}, {x + 0.011f, up, z + 0.095f}, {x + 0.011f, up, z},
           {x - 0.011f, up, z});
    m.Quad(kDark, {x - 0.011f, y + 0.02f, z + 0.1f}, {x + 0.011f, y + 0.02f, z + 0.1f},
           {x + 0.011f, up, z + 0.095f}, {x - 0.011f, up, z + 0.095f});
  }
}

/// Upright piano with its stool.
void Piano(PieceMaker& m) {
  const std::array<Surface, 4> finishes = {Surface{"painted_wood", {34, 32, 32}},
                                           Surface{"mahogany"}, Surface{"walnut"}, kWhitePaint};
  const Surface body = m.rng().Pick(finishes);
  constexpr float kHalf = 0.73f;
  const float top = m.Draw(1.12f, 1.24f);
  constexpr float kCase = 0.34f;  // depth of the upper case
  constexpr float kShelf = 0.62f;
  m.Box(body, {-kHalf, 0.05f, 0}, {kHalf, top, kCase});
  m.Box(body, {-kHalf - 0.02f, top, 0}, {kHalf + 0.02f, top + 0.03f, kCase + 0.03f});
  m.Box(body, {-kHalf, 0.6f, kCase}, {kHalf, 0.67f, kShelf});
  for (const float x : {-kHalf, kHalf - 0.06f}) {
    m.Box(body, {x, 0.67f, kCase}, {x + 0.06f, 0.8f, kShelf});
    m.TaperedBox(body, {x + 0.03f, 0, kShelf - 0.05f}, {0.05f, 0.05f},
                 {x + 0.03f, 0.6f, kShelf - 0.05f}, {0.08f, 0.08f});
    m.Box(body, {x, 0, 0}, {x + 0.06f, 0.05f, kShelf});
  }
  PianoKeys(m, kHalf - 0.06f, 0.67f, kCase + 0.08f);
  m.Box(Shaded(body, 0.9f), {-0.4f, 0.85f, kCase}, {0.4f, 0.87f, kCase + 0.05f});
  for (const float x : {-0.11f, 0.11f}) {  // an open score
    const Frame frame(&m, Turned({x, 0.87f, kCase + 0.03f}, 0.0f, -0.1f));
    Panel(m, kPaper, {-0.105f, 0, 0}, {0.105f, 0.28f, 0.006f});
  }
  for (const float x : {-0.07f, 0.0f, 0.07f})
    m.Box(kBrass, {x - 0.02f, 0.06f, kCase}, {x + 0.02f, 0.075f, kCase + 0.09f});
  Legs(m, body, {LegStyle::kTapered, {-0.32f, 0.72f}, {0.32f, 1.04f}, 0.42f, 0.05f});
  Cushion(m, {"leather", {60, 50, 46}}, {-0.34f, 0.42f, 0.7f}, {0.34f, 0.5f, 1.06f}, 0.02f);
  m.AddTop(top + 0.03f, {-kHalf, 0.0f}, {kHalf, kCase});
}

/// Logs, with flames above them.
void Fire(PieceMaker& m, float y, float z) {
  for (int i = 0; i < 3; ++i) {
    const float lean = 0.05f * static_cast<float>(i - 1);
    m.Bar({"weathered_wood", {120, 90, 70}},
          {-0.22f, y + 0.05f + 0.05f * static_cast<float>(i % 2), z + lean},
          {0.22f, y + 0.05f + 0.04f * static_cast<float>(i == 1), z - lean}, 0.045f, 6);
  }
  m.SetGlow(Glow::kLamp);
  for (int i = 0; i < 7; ++i) {
    const float x = -0.18f + 0.06f * static_cast<float>(i);
    const float tall = m.Draw(0.16f, 0.34f) * (1.0f - std::abs(x));
    const Surface flame{"lamp_shade", i % 2 == 0 ? Rgb8{255, 150, 40} : Rgb8{255, 205, 80}};
    m.Cone(flame, {x, y + 0.1f, z + (i % 2 == 0 ? 0.03f : -0.03f)}, 0.045f, 0.0f, tall, 4);
  }
  m.SetGlow(Glow::kNone);
}

void Fireplace(PieceMaker& m) {
  const std::array<Surface, 5> stones = {Surface{"red_brick"}, Surface{"white_brick"},
                                         Surface{"stone_wall"}, kWhitePaint,
                                         Surface{"white_marble"}};
  const Surface stone = m.rng().Pick(stones);
  const float half = 0.5f * m.Draw(1.25f, 1.6f);
  const float top = m.Draw(1.08f, 1.25f);
  constexpr float kDepth = 0.34f;
  constexpr float kMouth = 0.38f;  // half width of the opening
  constexpr float kLintel = 0.78f;
  m.Box(stone, {-half, 0, 0}, {-kMouth, top, kDepth});
  m.Box(stone, {kMouth, 0, 0}, {half, top, kDepth});
  m.Box(stone, {-kMouth, kLintel, 0}, {kMouth, top, kDepth});
  {  // the hearth, which opens to the front
    const Frame frame(&m, Turned({0, 0, 0}, 0.0f, kQuarterTurn));
    Hollow(m, {"brown_brick", {96, 84, 78}}, {-kMouth + 0.004f, 0.02f, 0.004f - kLintel},
           {kMouth - 0.004f, kDepth - 0.004f, -0.04f});
  }
  m.Box({"slate_tile", {120, 120, 120}}, {-half - 0.05f, 0, 0.02f},
        {half + 0.05f, 0.045f, kDepth + 0.3f});
  if (m.Chance(0.5)) {  // pilasters
    for (const float x : {-half, half - 0.17f})
      m.Box(Shaded(stone, 1.1f), {x - 0.01f, 0.04f, kDepth},
            {x + 0.18f, top - 0.05f, kDepth + 0.035f});
  }
  const Surface& mantel = m.Chance(0.5) ? m.palette().wood : kWhitePaint;
  m.Box(mantel, {-half - 0.1f, top, 0}, {half + 0.1f, top + 0.07f, kDepth + 0.1f});
  for (const float z :
       {kDepth + 0.04f, kDepth + 0.05f}) {  // the grate's bars, one behind the other
    m.Box(kBlackMetal, {-0.3f, z < kDepth + 0.045f ? 0.1f : 0.2f, z},
          {0.3f, z < kDepth + 0.045f ? 0.12f : 0.22f, z + 0.01f});
  }
  for (const float x : {-0.3f, -0.1f, 0.1f, 0.3f})
    Post(m, kBlackMetal, {x, 0.045f, kDepth + 0.05f}, 0.02f, 0.24f);
  Fire(m, 0.045f, 0.18f);
  m.AddTop(top + 0.07f, {-half, 0.04f}, {half, kDepth});
}

/// Tube frame of the bike between two points.
void Tube(PieceMaker& m, const Vec& a, const Vec& b, float radius = 0.028f) {
  m.Bar(kBlackPlastic, a, b, radius, 5);
}

void ExerciseBike(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.06f));
  const Surface color{"plastic", BrightColor(m)};
  for (const float z : {-0.45f, 0.5f})
    m.Box(kBlackPlastic, {-0.25f, 0, z - 0.03f}, {0.25f, 0.06f, z + 0.03f});
  Tube(m, {0, 0.05f, -0.45f}, {0, 0.3f, 0.1f});
  Tube(m, {0, 0.05f, 0.5f}, {0, 0.3f, 0.1f});
  Tube(m, {0, 0.28f, 0.1f}, {0, 0.86f, -0.2f});
  Tube(m, {0, 0.3f, 0.2f}, {0, 1.08f, 0.34f});
  {  // the flywheel under its cover
    const Frame frame(&m, Turned({-0.05f, 0.34f, 0.32f}, 0.0f, 0.0f, -kQuarterTurn));
    m.Cylinder(color, {0, 0, 0}, 0.24f, 0.1f, 14);
    m.Cylinder(kDark, {0, -0.005f, 0}, 0.14f, 0.11f, 10);
  }
  m.TaperedBox(kBlackPlastic, {0, 0.85f, -0.16f}, {0.1f, 0.24f}, {0, 0.92f, -0.22f},
               {0.24f, 0.18f});
  Tube(m, {-0.26f, 1.1f, 0.3f}, {0.26f, 1.1f, 0.3f}, 0.02f);
  for (const float x : {-0.26f, 0.26f}) Tube(m, {x, 1.1f, 0.3f}, {x, 1.16f, 0.12f}, 0.022f);
  const Frame frame(&m, Turned({0, 1.12f, 0.36f}, 0.0f, 0.6f));
  m.Box(kBlackPlastic, {-0.12f, 0, -0.02f}, {0.12f, 0.18f, 0.02f});
  m.Quad({"computer_screen"}, {0.1f, 0.03f, -0.022f}, {-0.1f, 0.03f, -0.022f},
         {-0.1f, 0.15f, -0.022f}, {0.1f, 0.15f, -0.022f});
}

void Treadmill(PieceMaker& m) {
  const Frame stretch(&m, Stretched(m, 0.08f));
  constexpr float kHalf = 0.38f;
  m.TaperedBox(kBlackPlastic, {0, 0.0f, 0}, {2.0f * kHalf, 1.65f}, {0, 0.16f, 0},
               {2.0f * kHalf - 0.04f, 1.6f});
  m.Quad(kRubber, {-0.25f, 0.165f, 0.76f}, {0.25f, 0.165f, 0.76f}, {0.25f, 0.165f, -0.6f},
         {-0.25f, 0.165f, -0.6f});
  m.Box(kGreyPlastic, {-kHalf, 0.1f, -0.82f}, {kHalf, 0.26f, -0.58f});
  for (const float x : {-kHalf + 0.03f, kHalf - 0.03f}) {
    m.Bar(kGreyPlastic, {x, 0.12f, -0.62f}, {x, 1.25f, -0.5f}, 0.035f, 5);
    m.Bar(kBlackPlastic, {x, 1.02f, -0.52f}, {x, 1.0f, 0.1f}, 0.025f, 5);
  }
  const Frame frame(&m, Turned({0, 1.16f, -0.52f}, 0.0f, -0.5f));
  m.Box(kBlackPlastic, {-kHalf, 0, -0.03f}, {kHalf, 0.3f, 0.04f});
  Sheet(m, {"computer_screen"}, {0, 0.08f, 0.043f}, 0.36f, 0.18f);
}

/// Acoustic guitar leaning back on a stand.
void Guitar(PieceMaker& m) {
  const std::array<Rgb8, 4> finishes = {Rgb8{222, 160, 84}, Rgb8{150, 74, 40}, Rgb8{60, 44, 40},
                                        Rgb8{200, 60, 44}};
  const Surface top{"painted_wood", m.rng().Pick(finishes)};
  for (const float x : {-0.16f, 0.16f}) {  // the stand
    m.Bar(kBlackMetal, {x, 0.014f, 0.26f}, {0, 0.5f, -0.03f}, 0.014f, 4);
  }
  m.Bar(kBlackMetal, {0, 0.014f, -0.2f}, {0, 0.5f, -0.03f}, 0.014f, 4);
  m.Box(kBlackMetal, {-0.16f, 0.05f, 0.2f}, {0.16f, 0.07f, 0.24f});
  const Frame frame(&m, Turned({0, 0.07f, 0.1f}, 0.0f, -0.22f));
  {
    // The body's outline in x and the frame's y; prisms rise along z here.
    std::vector<Vec2> outline;
    outline.reserve(13);
    const std::array<std::array<float, 2>, 7> side = {{{0.0f, 0.0f},
                                                       {0.14f, 0.02f},
                                                       {0.2f, 0.12f},
                                                       {0.18f, 0.21f},
                                                       {0.125f, 0.28f},
                                                       {0.15f, 0.38f},
                                                       {0.1f, 0.46f}}};
    for (const auto& [x, y] : side) outline.emplace_back(x, -y);
    for (std::size_t i = side.size(); i-- > 1;) outline.emplace_back(-side[i][0], -side[i][1]);
    const Frame upright(&m, Turned({0, 0, 0}, 0.0f, kQuarterTurn));
    m.Prism(top, outline, 0.0f, 0.1f);
    Disc(m, kDark, {0, 0.102f, -0.3f}, 0.05f, 10);
  }
  m.Box({"walnut"}, {-0.06f, 0.12f, 0.1f}, {0.06f, 0.145f, 0.115f});
  m.Box({"walnut", {150, 130, 120}}, {-0.027f, 0.36f, 0.1f}, {0.027f, 0.9f, 0.125f});
  m.TaperedBox(top, {0, 0.9f, 0.105f}, {0.06f, 0.025f}, {0, 1.06f, 0.09f}, {0.085f, 0.02f});
  m.Box(kPaper, {-0.008f, 0.14f, 0.118f}, {0.008f, 0.9f, 0.13f});  // strings, seen together
}

constexpr std::array kKinds = {FurnitureKind{"exercise_bike", Placement::kFree, 0.4f, ExerciseBike},
                               FurnitureKind{"fireplace", Placement::kAgainstWall, 1.0f, Fireplace},
                               FurnitureKind{"guitar", Placement::kFree, 0.1f, Guitar},
                               FurnitureKind{"piano", Placement::kAgainstWall, 0.5f, Piano},
                               FurnitureKind{"treadmill", Placement::kFree, 0.4f, Treadmill}};

}  // namespace

std::span<const FurnitureKind> Hobbies() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
