// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// A crate, or toys standing about, in a compartment whose floor is centred on `at`.
void Compartment(PieceMaker& m, const Vec& at, const Vec2& size, bool has_crate) {
  if (has_crate) {
    m.TaperedBox({"plastic", BrightColor(m)}, at, {0.75f * size.x(), 0.24f},
                 at + Vec(0, 0.55f * size.y(), 0), {0.85f * size.x(), 0.28f});
  } else {
    Sheet(m, {"toys"}, at, size.x() - 0.05f, size.y() - 0.04f);
  }
}

/// Open shelf for toys.
void ToyShelf(PieceMaker& m) {
  const Surface body = m.Chance(0.6) ? kWhitePaint : m.palette().wood;
  const float half = m.Draw(0.5f, 0.65f);
  constexpr float kDepth = 0.34f;
  constexpr float kRow = 0.36f;
  constexpr int kColumns = 3;
  const int rows = m.Between(2, 3);
  const float top = kRow * static_cast<float>(rows);
  const float width = 2.0f * half / kColumns;
  OpenBody(m, body, {-half, 0, 0}, {half, top, kDepth}, 0.025f);
  for (int r = 1; r < rows; ++r) {
    const float y = kRow * static_cast<float>(r);
    m.Box(body, {-half + 0.025f, y, 0.02f}, {half - 0.025f, y + 0.025f, kDepth - 0.01f});
  }
  for (int c = 0; c < kColumns; ++c) {
    const float x = -half + width * static_cast<float>(c);
    if (c > 0) {
      m.Box(body, {x - 0.012f, 0.025f, 0.02f}, {x + 0.012f, top - 0.025f, kDepth - 0.005f});
    }
    for (int r = 0; r < rows; ++r) {
      const float y = kRow * static_cast<float>(r) + 0.025f;
      Compartment(m, {x + 0.5f * width, y, 0.19f}, {width, kRow}, (r + c) % 2 == 0);
    }
  }
  m.AddTop(top, {-half, 0.0f}, {half, kDepth});
}

/// Tepee: poles that cross at the top, four sides of cloth, one of them open as a door.
void PlayTent(PieceMaker& m) {
  const float half = m.Draw(0.52f, 0.62f);
  const float height = m.Draw(1.3f, 1.55f);
  const std::array<Surface, 4> cloths = {
      Surface{"canvas", {240, 232, 214}}, Surface{"striped_cotton", m.palette().accent.tint},
      Surface{"dotted_fabric", m.palette().accent.tint}, Surface{"canvas", BrightColor(m)}};
  const Surface cloth = m.rng().Pick(cloths);
  const Vec apex(0, height, 0);
  for (const float x : {-half, half}) {
    for (const float z : {-half, half}) {
      const Vec foot(x, 0.016f, z);
      m.Bar({"pine"}, foot, foot + 1.13f * (apex - foot), 0.018f, 5);
    }
  }
  const float cut = 0.06f;  // the cloth ends a bit below the crossing
  const std::array<Vec, 4> feet = {Vec(-half, 0.0f, half), Vec(half, 0.0f, half),
                                   Vec(half, 0.0f, -half), Vec(-half, 0.0f, -half)};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec& a = feet[i];
    const Vec& b = feet[(i + 1) % 4];
    const Vec up_a = a + (1.0f - cut) * (apex - a);
    const Vec up_b = b + (1.0f - cut) * (apex - b);
    if (i != 0) {
      m.Quad(cloth, a, b, up_b, up_a);
      const Vec in = Vec(-0.012f * (a + b).normalized());  // the inside, in its own shade
      m.Quad(Shaded(cloth, 0.6f), b + in, a + in, up_a + in, up_b + in);
      continue;
    }
    // The front: a flap on either side, tied back.
    const Vec middle = 0.5f * (a + b);
    const Vec top = middle + 0.72f * (apex - middle);
    m.Quad(cloth, a, a + 0.18f * (b - a), top, up_a);
    m.Quad(cloth, b + 0.18f * (a - b), b, up_b, top);
    m.Triangle(cloth, top, up_b, up_a);
    m.Quad(Shaded(cloth, 0.5f), {-0.2f, 0.01f, half - 0.05f}, {0.2f, 0.01f, half - 0.05f},
           {0.2f, 0.01f, -0.2f}, {-0.2f, 0.01f, -0.2f});
  }
  const Frame frame(&m, Turned({0, 0.01f, 0.12f}, 0.4f));
  Pillow(m, m.palette().accent, {-0.24f, 0, -0.2f}, {0.24f, 0.15f, 0.2f});
}

void SmallStool(PieceMaker& m, const Vec& at, const Surface& surface) {
  const Frame frame(&m, at);
  Legs(m, m.palette().wood, {LegStyle::kSplayed, {-0.15f, -0.15f}, {0.15f, 0.15f}, 0.27f, 0.035f});
  m.Cylinder(surface, {0, 0.27f, 0}, 0.15f, 0.035f, 10);
}

void KidsTable(PieceMaker& m) {
  const Surface top{"painted_wood", m.Chance(0.5) ? BrightColor(m) : Rgb8{245, 242, 235}};
  constexpr float kHeight = 0.5f;
  Legs(m, m.palette().wood,
       {LegStyle::kTapered, {-0.33f, -0.25f}, {0.33f, 0.25f}, kHeight - 0.03f, 0.05f});
  m.Box(top, {-0.37f, kHeight - 0.03f, -0.29f}, {0.37f, kHeight, 0.29f});
  for (int i = 0; i < 2; ++i) {  // drawings and crayons
    const Vec at(m.Draw(-0.2f, 0.2f), kHeight + 0.003f, i == 0 ? -0.12f : 0.14f);
    const Frame frame(&m, at, m.Draw(-0.4f, 0.4f));
    m.Quad(kPaper, {-0.13f, 0, 0.1f}, {0.13f, 0, 0.1f}, {0.13f, 0, -0.1f}, {-0.13f, 0, -0.1f});
    for (int k = 0; k < 3; ++k) {
      const Vec2 crayon = m.Draw(Vec2(-0.08f, -0.06f), Vec2(0.08f, 0.06f));
      const Frame turn(&m, {crayon.x(), 0.0f, crayon.y()}, m.Draw(0.0f, 3.0f));
      m.Box({"plastic", BrightColor(m)}, {-0.05f, 0, -0.008f}, {0.05f, 0.014f, 0.008f});
    }
  }
  SmallStool(m, {-0.1f, 0, 0.48f}, {"painted_wood", BrightColor(m)});
  SmallStool(m, {0.12f, 0, -0.5f}, {"painted_wood", BrightColor(m)});
}

/// Two boards leaning together: paper or slate to draw on.
void Easel(PieceMaker& m) {
  const Surface& wood = m.palette().wood;
  const float height = m.Draw(1.1f, 1.3f);
  for (const float side : {-1.0f, 1.0f}) {
    const Frame frame(&m,
                      Turned({0, 0, 0.3f * side}, side > 0 ? 0.0f : 2.0f * kQuarterTurn, -0.24f));
    for (const float x : {-0.3f, 0.3f})
      m.Box(wood, {x - 0.02f, 0.01f, -0.02f}, {x + 0.02f, height, 0.015f});
    m.Box(wood, {-0.3f, 0.4f, -0.01f}, {0.3f, 0.44f, 0.07f});
    if (side < 0) {
      m.Box({"blackboard"}, {-0.28f, 0.46f, -0.01f}, {0.28f, height - 0.06f, 0.01f});
      continue;
    }
    m.Box(kWhitePaint, {-0.28f, 0.46f, -0.01f}, {0.28f, height - 0.06f, 0.01f});
    Sheet(m, {m.Chance(0.5) ? "painting_flowers" : "painting_abstract"}, {0, 0.52f, 0.013f}, 0.42f,
          height - 0.66f);
    for (const float x : {-0.18f, -0.06f, 0.08f})
      m.Cylinder({"plastic", BrightColor(m)}, {x, 0.44f, 0.04f}, 0.025f, 0.06f, 6);
  }
}

constexpr std::array kKinds = {FurnitureKind{"easel", Placement::kFree, 0.4f, Easel},
                               FurnitureKind{"kids_table", Placement::kFree, 0.3f, KidsTable},
                               FurnitureKind{"play_tent", Placement::kFree, 0.4f, PlayTent},
                               FurnitureKind{"toy_shelf", Placement::kAgainstWall, 0.5f, ToyShelf}};

}  // namespace

std::span<const FurnitureKind> Kids() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
