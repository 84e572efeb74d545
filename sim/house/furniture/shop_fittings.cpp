// SPDX-License-Identifier: MIT
// Tills, changing booths, signs: what shops have besides goods.
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// A counter with a till on it; customers pass before it (+z).
void TillCounter(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.3f, 2.2f);
  const float high = m.Draw(0.88f, 1.02f);
  const float deep = 0.5f * m.Draw(0.6f, 0.75f);
  const Surface body = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
  m.Box(body, {-half + 0.02f, 0.06f, -deep + 0.02f}, {half - 0.02f, high - 0.04f, deep - 0.02f});
  m.Box(kDark, {-half + 0.06f, 0, -deep + 0.06f}, {half - 0.06f, 0.06f, deep - 0.06f});
  m.Box(m.palette().counter, {-half, high - 0.04f, -deep}, {half, high, deep});
  const float x = m.Draw(-0.5f, 0.5f) * half;
  m.Box(kBlackPlastic, {x - 0.2f, high, -0.22f}, {x + 0.2f, high + 0.1f, 0.15f});
  m.Box(kBlackPlastic, {x - 0.04f, high + 0.1f, -0.1f}, {x + 0.04f, high + 0.3f, -0.04f});
  m.Box(kDark, {x - 0.17f, high + 0.2f, -0.13f}, {x + 0.17f, high + 0.45f, -0.1f});
  m.Box(kGreyPlastic, {x + 0.28f, high, 0.05f}, {x + 0.36f, high + 0.12f, 0.17f});
  if (m.Chance(0.5)) {  // a belt
    m.Box(kRubber, {-half + 0.05f, high, -deep + 0.1f},
          {std::max(-half + 0.1f, x - 0.25f), high + 0.01f, deep - 0.1f});
  }
  m.AddTop(high, {x + 0.4f, -deep + 0.05f}, {std::max(x + 0.5f, half - 0.05f), deep - 0.05f});
}

/// Where clothes are tried on: boards on three sides, a curtain half drawn, a mirror at the back.
void ChangingBooth(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.95f, 1.15f);
  const float deep = m.Draw(1.0f, 1.2f);
  const float high = m.Draw(1.95f, 2.1f);
  const Surface board = m.Chance(0.5) ? m.palette().wood : kWhitePaint;
  m.Box(board, {-half, 0, 0}, {half, high, 0.03f});
  for (const float x : {-half, half - 0.04f}) m.Box(board, {x, 0, 0.03f}, {x + 0.04f, high, deep});
  m.Box(board, {-half + 0.04f, high - 0.06f, deep - 0.05f}, {half - 0.04f, high, deep});
  Panel(m, kMirror, {-0.25f, 0.4f, 0.03f}, {0.25f, 1.8f, 0.04f});
  m.Box(m.palette().wood, {-half + 0.04f, 0.42f, 0.04f}, {-half + 0.34f, 0.46f, 0.5f});
  const float drawn = -half + 0.05f + m.Draw(0.25f, 0.95f) * (2.0f * half - 0.1f);
  const Surface cloth{"velvet", MutedColor(m)};
  m.Box(cloth, {-half + 0.05f, 0.2f, deep - 0.04f}, {drawn, high - 0.06f, deep - 0.01f});
}

/// A board with coloured bands, hung over a wall of goods.
void ShopSign(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.9f, 2.0f);
  const float high = m.Draw(0.25f, 0.45f);
  const Surface ground{"plastic", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
  Panel(m, ground, {-half, 0, 0}, {half, high, 0.05f});
  const Surface letters = m.Chance(0.7) ? kWhitePlastic : kBlackPlastic;
  float x = -0.8f * half;
  while (x < 0.7f * half) {
    const float wide = m.Draw(0.05f, 0.12f);
    Panel(m, letters, {x, 0.3f * high, 0.05f}, {x + wide, 0.72f * high, 0.058f});
    x += wide + 0.04f;
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"changing_booth", Placement::kAgainstWall, 0.7f, ChangingBooth},
    FurnitureKind{"shop_sign", Placement::kOnWall, 0.0f, ShopSign, 0.8f, 2.4f},
    FurnitureKind{"till_counter", Placement::kFree, 0.6f, TillCounter, 1.1f, 3.0f}};

}  // namespace

std::span<const FurnitureKind> ShopFittings() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
