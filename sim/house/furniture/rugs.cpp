// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kThick = 0.012f;

/// Flat band between two rectangles around the origin, looking up.
void Band(PieceMaker& m, const Surface& surface, const Vec2& outer, const Vec2& inner) {
  const auto corner = [](const Vec2& half, int i) {
    return Vec(i == 1 || i == 2 ? half.x() : -half.x(), kThick, i < 2 ? half.y() : -half.y());
  };
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    m.Quad(surface, corner(outer, i), corner(outer, next), corner(inner, next), corner(inner, i));
  }
}

void Field(PieceMaker& m, const Surface& surface, const Vec2& half) {
  m.Quad(surface, {-half.x(), kThick, half.y()}, {half.x(), kThick, half.y()},
         {half.x(), kThick, -half.y()}, {-half.x(), kThick, -half.y()});
}

void Edge(PieceMaker& m, const Surface& surface, const Vec2& half) {
  const auto corner = [&](int i, float y) {
    return Vec(i == 1 || i == 2 ? half.x() : -half.x(), y, i < 2 ? half.y() : -half.y());
  };
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    m.Quad(surface, corner(i, 0), corner(next, 0), corner(next, kThick), corner(i, kThick));
  }
}

void Fringe(PieceMaker& m, const Vec2& half) {
  const Surface threads{"linen", {228, 216, 190}};
  for (const float x : {-half.x() - 0.04f, half.x()}) {
    Panel(m, threads, {x, 0, -half.y()}, {x + 0.04f, 0.6f * kThick, half.y()});
  }
}

/// Rugs whose material is the picture of a whole rug, with its own border.
bool IsPicture(const Surface& rug) {
  return rug.material == "persian_rug" || rug.material == "kids_rug";
}

/// The picture once over the rug, or several times along it if it is long.
void PictureField(PieceMaker& m, const Surface& surface, const Vec2& half) {
  const float times = std::max(1.0f, std::round(0.7f * half.x() / half.y()));
  m.Picture(surface, {-half.x(), kThick, half.y()}, {half.x(), kThick, half.y()},
            {half.x(), kThick, -half.y()}, {-half.x(), kThick, -half.y()},
            {Vec2(0, 0), Vec2(times, 1)});
}

void RectangularRug(PieceMaker& m, const Vec2& half) {
  const Surface& rug = m.palette().rug;
  Edge(m, Shaded(rug, 0.7f), half);
  if (IsPicture(rug)) {
    PictureField(m, rug, half);
    if (rug.material == "persian_rug") Fringe(m, half);
    return;
  }

  const Vec2 ones(1.0f, 1.0f);
  switch (m.Below(3)) {
    case 0:
      Field(m, rug, half);
      break;
    case 1: {  // a plain border
      Band(m, m.palette().accent, half, half - 0.09f * ones);
      Field(m, rug, half - 0.09f * ones);
      break;
    }
    case 2: {  // dark and light bands
      const Vec2 dark = half - 0.14f * ones;
      const Vec2 light = dark - 0.04f * ones;
      Band(m, Shaded(rug, 0.6f), half, dark);
      Band(m, {"linen", {222, 208, 176}}, dark, light);
      Field(m, rug, light);
      break;
    }
  }
  if (m.Chance(0.5)) Fringe(m, half);
}

void Rug(PieceMaker& m) {
  const float width = m.Width(1.9f, 2.9f, 0.08f);
  RectangularRug(m, 0.5f * Vec2(width, m.Draw(1.3f, 2.0f)));
}

void RunnerRug(PieceMaker& m) {
  const float width = m.Width(1.8f, 2.8f, 0.08f);
  RectangularRug(m, 0.5f * Vec2(width, m.Draw(0.62f, 0.8f)));
}

void RoundRug(PieceMaker& m) {
  const float radius = m.Draw(0.65f, 1.1f);
  const Surface& rug = m.palette().rug;
  const float inner = m.Draw(0.75f, 0.9f) * radius;
  const Surface border = m.Chance(0.5) ? m.palette().accent : Shaded(rug, 0.7f);
  m.Turn(border, {0, 0, 0}, {{radius, 0.0f}, {radius, kThick}, {inner, kThick}}, 24);
  PictureDisc(m, rug, {0, kThick, 0}, inner, 24);
}

void BathMat(PieceMaker& m) {
  const Surface towel{"terry_towel", m.palette().accent.tint};
  const Vec2 half = m.Draw(Vec2(0.35f, 0.22f), Vec2(0.42f, 0.28f));
  Edge(m, towel, half);
  Band(m, Shaded(towel, 0.8f), half, half - Vec2(0.05f, 0.05f));
  Field(m, towel, half - Vec2(0.05f, 0.05f));
}

void DoorMat(PieceMaker& m) {
  const Surface mat{"jute_rug", m.Chance(0.5) ? Rgb8{255, 255, 255} : Rgb8{120, 116, 110}};
  const Vec2 half(m.Draw(0.34f, 0.42f), 0.24f);
  Edge(m, mat, half);
  Band(m, kRubber, half, half - Vec2(0.035f, 0.035f));
  Field(m, mat, half - Vec2(0.035f, 0.035f));
}

constexpr std::array kKinds = {
    FurnitureKind{"bath_mat", Placement::kRug, 0.0f, BathMat},
    FurnitureKind{"door_mat", Placement::kRug, 0.0f, DoorMat},
    FurnitureKind{"round_rug", Placement::kRug, 0.0f, RoundRug},
    FurnitureKind{"rug", Placement::kRug, 0.0f, Rug, 1.2f, 3.6f},
    FurnitureKind{"runner_rug", Placement::kRug, 0.0f, RunnerRug, 1.0f, 5.0f}};

}  // namespace

std::span<const FurnitureKind> Rugs() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
