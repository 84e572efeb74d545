// SPDX-License-Identifier: MIT
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// Television whose lower edge is centred on `low`, looking to the front.
void Television(PieceMaker& m, const Vec& low, float width) {
  const float height = 0.565f * width;
  m.Box(kBlackPlastic, low - Vec(0.5f * width, 0, 0), low + Vec(0.5f * width, height, 0.04f));
  Sheet(m, {"tv_screen"}, low + Vec(0, 0.018f, 0.043f), width - 0.03f, height - 0.033f);
}

void TvStand(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.3f, 2.0f, 0.02f);
  const float depth = m.Draw(0.38f, 0.46f);
  const float top = m.Draw(0.42f, 0.56f);
  const float foot = m.Draw(0.04f, 0.14f);
  const Surface& surface = m.Chance(0.6) ? m.palette().wood : m.palette().cabinet;
  Legs(m, m.palette().metal,
       {LegStyle::kSquare, {-half + 0.06f, 0.03f}, {half - 0.06f, depth - 0.03f}, foot, 0.05f});
  const float third = half / 3.0f;
  const bool is_open = m.Chance(0.6);  // in the middle
  if (is_open) {
    for (const float x0 : {-half, third}) {
      Body(m, surface, {x0, foot, 0}, {x0 + 2.0f * third, top - 0.03f, depth});
      Doors(m, surface, {x0, x0 + 2.0f * third, foot, top - 0.03f, depth}, 1);
    }
    OpenBody(m, surface, {-third, foot, 0}, {third, top - 0.03f, depth - 0.01f}, 0.025f);
    m.Box(kBlackPlastic, {-0.8f * third, foot + 0.03f, 0.1f},
          {0.8f * third, foot + 0.1f, depth - 0.06f});
  } else {
    Body(m, surface, {-half, foot, 0}, {half, top - 0.03f, depth});
    Doors(m, surface, {-half, half, foot, top - 0.03f, depth}, 3, HandleAt::kTop);
  }
  m.Box(surface, {-half - 0.01f, top - 0.03f, 0}, {half + 0.01f, top, depth + 0.015f});
  const float width = std::min(m.Draw(1.0f, 1.4f), 2.0f * half - 0.2f);
  for (const float x : {-0.3f * width, 0.3f * width}) {
    m.Box(kBlackPlastic, {x - 0.02f, top, 0.1f}, {x + 0.02f, top + 0.06f, 0.3f});
  }
  Television(m, {0, top + 0.05f, 0.18f}, width);
  if (m.Chance(0.4)) {  // a soundbar
    m.Box(kDark, {-0.42f, top, 0.28f}, {0.42f, top + 0.055f, 0.35f});
  }
  const float free = half - 0.5f * width;
  if (free > 0.16f) {
    Ornament(m, {half - 0.5f * free, top, 0.5f * depth}, {free - 0.04f, 0.3f, 0.25f});
    m.AddTop(top, {-half, 0.0f}, {-half + free, depth});
  }
}

void WallTv(PieceMaker& m) {
  Television(m, {0, 0, 0.03f}, m.Draw(0.9f, 1.45f));
}

constexpr std::array kKinds = {
    FurnitureKind{"tv_stand", Placement::kAgainstWall, 1.0f, TvStand, 1.1f, 2.6f},
    FurnitureKind{"wall_tv", Placement::kOnWall, 1.0f, WallTv}};

}  // namespace

std::span<const FurnitureKind> Screens() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
