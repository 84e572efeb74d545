// SPDX-License-Identifier: MIT
#include "sim/house/furniture/parts.h"

#include <algorithm>

#include "sim/base/elementary.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim::furniture {

Eigen::Affine3f Turned(const Vec& at, float yaw, float pitch, float roll) {
  const Eigen::Matrix3f turn = RotationAbout<float>(Vec::UnitY(), yaw) *
                               RotationAbout<float>(Vec::UnitX(), pitch) *
                               RotationAbout<float>(Vec::UnitZ(), roll);
  return Eigen::Translation3f(at) * turn;
}

std::vector<float> Spaced(float low, float high, float pitch) {
  std::vector<float> places;
  for (int i = 0; low + static_cast<float>(i) * pitch < high; ++i) {
    places.push_back(low + static_cast<float>(i) * pitch);
  }
  return places;
}

Eigen::Affine3f Stretched(PieceMaker& m, float share) {
  const float x = m.Draw(1.0f - share, 1.0f + share);
  const float y = m.Draw(1.0f - share, 1.0f + share);
  const float z = m.Draw(1.0f - share, 1.0f + share);
  return Eigen::Affine3f(Eigen::Scaling(Vec(x, y, z)));
}

void Post(PieceMaker& m, const Surface& surface, const Vec& bottom, float thickness, float height) {
  const float half = 0.5f * thickness;
  const Vec low = bottom - Vec(half, 0, half);
  const Vec high = bottom + Vec(half, height, half);
  Panel(m, surface, low, high);
  m.Quad(surface, {high.x(), low.y(), low.z()}, low, {low.x(), high.y(), low.z()},
         {high.x(), high.y(), low.z()});
}

void Panel(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high) {
  const auto at = [&](int x, int y, int z) {
    return Vec(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  m.Quad(surface, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  m.Quad(surface, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
  m.Quad(surface, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  m.Quad(surface, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
}

namespace {

/// Sides and top between a level rectangle and a smaller one above (or below: flipped) it.
void Cap(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high, float inset,
         bool upwards) {
  const float y = upwards ? low.y() : high.y();
  const float tip = upwards ? high.y() : low.y();
  std::array<Vec, 4> rim = {Vec(low.x(), y, high.z()), Vec(high.x(), y, high.z()),
                            Vec(high.x(), y, low.z()), Vec(low.x(), y, low.z())};
  std::array<Vec, 4> top = {
      Vec(low.x() + inset, tip, high.z() - inset), Vec(high.x() - inset, tip, high.z() - inset),
      Vec(high.x() - inset, tip, low.z() + inset), Vec(low.x() + inset, tip, low.z() + inset)};
  if (!upwards) {
    std::reverse(rim.begin(), rim.end());
    std::reverse(top.begin(), top.end());
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    m.Quad(surface, rim[i], rim[next], top[next], top[i]);
  }
  m.Quad(surface, top[0], top[1], top[2], top[3]);
}

}  // namespace

void Cushion(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high, float bevel) {
  const float y = high.y() - bevel;
  const std::array<Vec2, 4> corners = {Vec2(low.x(), high.z()), Vec2(high.x(), high.z()),
                                       Vec2(high.x(), low.z()), Vec2(low.x(), low.z())};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2& p = corners[i];
    const Vec2& q = corners[(i + 1) % 4];
    m.Quad(surface, {p.x(), low.y(), p.y()}, {q.x(), low.y(), q.y()}, {q.x(), y, q.y()},
           {p.x(), y, p.y()});
  }
  Cap(m, surface, {low.x(), y, low.z()}, high, bevel, true);
}

void Pillow(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high) {
  const float middle = 0.5f * (low.y() + high.y());
  const float inset = 0.28f * std::min(high.x() - low.x(), high.z() - low.z());
  Cap(m, surface, {low.x(), middle, low.z()}, high, inset, true);
  Cap(m, surface, low, {high.x(), middle, high.z()}, inset, false);
}

void Hollow(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high, float slant) {
  const auto at = [&](int x, int y, int z) {
    const float inset = y ? 0.0f : slant;
    return Vec(x ? high.x() - inset : low.x() + inset, y ? high.y() : low.y(),
               z ? high.z() - inset : low.z() + inset);
  };
  m.Quad(surface, at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0));
  m.Quad(surface, at(1, 0, 1), at(0, 0, 1), at(0, 1, 1), at(1, 1, 1));
  m.Quad(surface, at(0, 0, 1), at(0, 0, 0), at(0, 1, 0), at(0, 1, 1));
  m.Quad(surface, at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0));
  m.Quad(surface, at(0, 0, 1), at(1, 0, 1), at(1, 0, 0), at(0, 0, 0));
}

void Disc(PieceMaker& m, const Surface& surface, const Vec& centre, float radius, int sides) {
  m.Turn(surface, centre, {{radius, 0.0f}, {0.0f, 0.0f}}, sides);
}

void PictureDisc(PieceMaker& m, const Surface& surface, const Vec& centre, float radius,
                 int sides) {
  // Textures lie in the frame's axes: move those to the picture's corner.
  const float half = 0.5f * FindMaterial(surface.material).metres;
  const Frame frame(&m, centre - Vec(half, 0, half));
  Disc(m, surface, {half, 0, half}, radius, sides);
}

void Sheet(PieceMaker& m, const Surface& surface, const Vec& low, float width, float height) {
  const Vec half(0.5f * width, 0, 0);
  const Vec up(0, height, 0);
  m.Picture(surface, low - half, low + half, low + half + up, low - half + up);
}

void FamilyPhoto(PieceMaker& m, const Vec& low, float width, float height) {
  const auto column = static_cast<float>(m.Below(3));
  const auto row = static_cast<float>(m.Below(3));
  const Vec2 cell = Vec2(column, row) / 3.0f;
  const Vec half(0.5f * width, 0, 0);
  const Vec up(0, height, 0);
  // What is inside the painted frame of a cell.
  m.Picture({"family_photos"}, low - half, low + half, low + half + up, low - half + up,
            {cell + Vec2(0.08f, 0.075f), cell + Vec2(0.25f, 0.24f)});
}

void Hoop(PieceMaker& m, const Surface& surface, const Vec& centre, float radius, float thickness,
          int pieces) {
  // A tube of three sides: two that meet outside, one inside.
  constexpr int kSides = 3;
  const auto point = [&](int piece, int side) {
    const float turn = 4.0f * kQuarterTurn;
    const float around = turn * static_cast<float>(piece) / static_cast<float>(pieces);
    const float across = turn * static_cast<float>(side) / static_cast<float>(kSides);
    const float out = radius + thickness * Cos(across);
    return Vec(centre + Vec(thickness * Sin(across), out * Sin(around), out * Cos(around)));
  };
  for (int i = 0; i < pieces; ++i) {
    for (int k = 0; k < kSides; ++k) {
      m.Quad(surface, point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i + 1, k));
    }
  }
}

void Tap(PieceMaker& m, const Vec& at, float height, float reach) {
  const Vec top = at + Vec(0, height, 0);
  m.Cylinder(kChrome, at, 0.024f, 0.03f, 6);
  m.Bar(kChrome, at, top, 0.015f, 5);
  m.Bar(kChrome, top, top + Vec(0, 0.02f, reach), 0.014f, 5);
  const Vec lever = at + Vec(0.03f, 0.45f * height, 0);
  m.Box(kChrome, lever - Vec(0.02f, 0.01f, 0.01f), lever + Vec(0.05f, 0.01f, 0.01f));
}

LegStyle DrawLegStyle(PieceMaker& m) {
  static constexpr std::array kStyles = {LegStyle::kSquare, LegStyle::kTapered, LegStyle::kRound,
                                         LegStyle::kSplayed};
  return m.rng().Pick(kStyles);
}

namespace {

/// One leg from `foot` up; `inwards` is the level direction to the middle of the piece.
void LegPiece(PieceMaker& m, const Surface& surface, const LegSet& legs, const Vec& foot,
              const Vec& inwards) {
  const Vec top = foot + Vec(0, legs.height, 0);
  const Vec2 full(legs.thickness, legs.thickness);
  switch (legs.style) {
    case LegStyle::kSquare:
      return Post(m, surface, foot, legs.thickness, legs.height);
    case LegStyle::kTapered:
      return m.TaperedBox(surface, foot, 0.5f * full, top, full);
    case LegStyle::kRound:
      return m.Cylinder(surface, foot, 0.5f * legs.thickness, legs.height, 6);
    case LegStyle::kSplayed:
      return m.TaperedBox(surface, foot, 0.5f * full, top + 0.18f * legs.height * inwards, full);
  }
}

}  // namespace

void Legs(PieceMaker& m, const Surface& surface, const LegSet& legs) {
  const Vec2 half = 0.5f * Vec2(legs.thickness, legs.thickness);
  const Vec2 low = legs.low + half;
  const Vec2 high = legs.high - half;
  const Vec2 middle = 0.5f * (low + high);
  for (const Vec2& p : {low, Vec2(low.x(), high.y()), Vec2(high.x(), low.y()), high}) {
    const Vec inwards = Vec(middle.x() - p.x(), 0, middle.y() - p.y()).normalized();
    LegPiece(m, surface, legs, {p.x(), 0, p.y()}, inwards);
  }
}

void Body(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high) {
  m.Box(surface, low, high);
  const float z = high.z() + 0.002f;
  constexpr float kRim = 0.008f;
  m.Quad(Shaded(surface, 0.35f), {low.x() + kRim, low.y() + kRim, z},
         {high.x() - kRim, low.y() + kRim, z}, {high.x() - kRim, high.y() - kRim, z},
         {low.x() + kRim, high.y() - kRim, z});
}

void OpenBody(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high,
              float thickness) {
  const Vec x(thickness, 0, 0);
  const Vec y(0, thickness, 0);
  m.Box(surface, low, {low.x() + thickness, high.y(), high.z()});
  m.Box(surface, {high.x() - thickness, low.y(), low.z()}, high);
  m.Box(surface, low + x, Vec(high.x(), low.y(), high.z()) - x + y);
  m.Box(surface, Vec(low.x(), high.y(), low.z()) + x - y, high - x);
  const float back = low.z() + 0.01f;
  m.Quad(Shaded(surface, 0.72f), Vec(low.x(), low.y(), back) + x, Vec(high.x(), low.y(), back) - x,
         Vec(high.x(), high.y(), back) - x, Vec(low.x(), high.y(), back) + x);
  m.Quad(surface, {high.x(), low.y(), low.z()}, low, {low.x(), high.y(), low.z()},
         {high.x(), high.y(), low.z()});
}

}  // namespace bulletnav::sim::furniture
