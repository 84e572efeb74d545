// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

float Drop(PieceMaker& m, float usual) {
  return m.request().height > 0.0f ? m.request().height : usual;
}

/// Drapes at both sides of a window as wide as what is asked for, under a rod.
void Curtain(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.2f);
  const float top = Drop(m, m.Draw(2.1f, 2.35f));
  const float share = m.Draw(0.36f, 0.5f);  // of a half that a drape covers
  const Surface rod = m.Chance(0.5) ? m.palette().metal : m.palette().wood;
  constexpr float kOut = 0.08f;
  const float y = top - 0.03f;
  m.Bar(rod, {-half + 0.05f, y, kOut}, {half - 0.05f, y, kOut}, 0.014f, 5);
  for (const float x : {-half + 0.03f, half - 0.03f})
    m.Ball(rod, {x, y, kOut}, {0.03f, 0.03f, 0.03f}, 6);
  for (const float x : {-half + 0.12f, half - 0.12f})
    m.Box(rod, {x - 0.01f, y - 0.02f, 0}, {x + 0.01f, y + 0.02f, kOut});
  const float width = share * half;
  const float drop = y - 0.01f;
  const int folds = std::max(4, static_cast<int>(std::lround(width / 0.085f)));
  m.Drape(m.palette().accent, {-half + 0.05f, y, kOut}, {-half + 0.05f + width, y, kOut}, drop,
          0.07f, folds);
  m.Drape(m.palette().accent, {half - 0.05f - width, y, kOut}, {half - 0.05f, y, kOut}, drop, 0.07f,
          folds);
  if (m.Chance(0.4)) {  // tied back
    for (const float x : {-half + 0.04f, half - 0.06f - width}) {
      m.Box(m.palette().other_accent, {x, 0.42f * top, 0.02f},
            {x + width + 0.02f, 0.42f * top + 0.06f, 0.14f});
    }
  }
}

/// Slats, or a sheet, over the upper part of a window.
void Blind(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.8f, 1.6f);
  const float top = Drop(m, m.Draw(0.9f, 1.3f));
  const float low = m.request().height > 0.0f ? 0.0f : m.Draw(0.0f, 0.1f);
  const Surface& shade = m.palette().shade;
  m.Box(shade, {-half, top - 0.06f, 0}, {half, top, 0.06f});
  if (m.Chance(0.5)) {
    m.Box(shade, {-half + 0.015f, low + 0.03f, 0.02f}, {half - 0.015f, top - 0.06f, 0.028f});
    m.Box(m.palette().wood, {-half + 0.015f, low, 0.012f}, {half - 0.015f, low + 0.03f, 0.036f});
    return;
  }
  const int slats = std::clamp(static_cast<int>((top - low) / 0.06f), 4, 24);
  const float pitch = (top - 0.06f - low) / static_cast<float>(slats);
  for (int i = 0; i < slats; ++i) {
    const float y = low + pitch * static_cast<float>(i);
    const Surface tone = Shaded(shade, i % 2 == 0 ? 1.0f : 0.93f);
    m.Quad(tone, {-half + 0.01f, y, 0.045f}, {half - 0.01f, y, 0.045f},
           {half - 0.01f, y + 0.75f * pitch, 0.01f}, {-half + 0.01f, y + 0.75f * pitch, 0.01f});
  }
  for (const float x : {-0.6f * half, 0.6f * half})
    m.Box(Shaded(shade, 0.8f), {x - 0.008f, low, 0.047f}, {x + 0.008f, top, 0.05f});
}

/// Columns between two pipes, under a window.
void Radiator(PieceMaker& m) {
  const float width = m.Width(0.7f, 1.3f, 0.06f);
  const float half = 0.5f * width;
  const float top = m.Fits(0.7f) ? m.Draw(0.58f, 0.7f) : m.request().height;
  constexpr float kLow = 0.1f;
  const Surface& white = kWhiteEnamel;
  if (m.Chance(0.5)) {  // a ribbed panel
    m.Box(white, {-half, kLow, 0.03f}, {half, top, 0.1f});
    const int ribs = std::max(4, static_cast<int>(width / 0.1f));
    for (int i = 0; i < ribs; ++i) {
      const float x = -half + width * (static_cast<float>(i) + 0.3f) / static_cast<float>(ribs);
      m.Quad(Shaded(white, 0.72f), {x, kLow + 0.05f, 0.103f}, {x + 0.03f, kLow + 0.05f, 0.103f},
             {x + 0.03f, top - 0.05f, 0.103f}, {x, top - 0.05f, 0.103f});
    }
    m.Quad(Shaded(white, 0.55f), {-half + 0.02f, top + 0.002f, 0.09f},
           {half - 0.02f, top + 0.002f, 0.09f}, {half - 0.02f, top + 0.002f, 0.04f},
           {-half + 0.02f, top + 0.002f, 0.04f});
  } else {
    const int columns = std::max(6, static_cast<int>(width / 0.075f));
    const float pitch = width / static_cast<float>(columns);
    for (int i = 0; i < columns; ++i) {
      const float x = -half + pitch * (static_cast<float>(i) + 0.5f);
      m.Box(white, {x - 0.35f * pitch, kLow, 0.03f}, {x + 0.35f * pitch, top, 0.13f});
    }
    for (const float y : {kLow + 0.05f, top - 0.09f})
      m.Box(Shaded(white, 0.8f), {-half, y, 0.06f}, {half, y + 0.04f, 0.1f});
  }
  for (const float x : {-half + 0.08f, half - 0.08f}) Post(m, white, {x, 0, 0.06f}, 0.03f, kLow);
  m.Box(white, {half, kLow + 0.04f, 0.05f}, {half + 0.05f, kLow + 0.08f, 0.09f});  // the valve
  m.Box(kGreyPlastic, {half + 0.015f, kLow + 0.08f, 0.045f}, {half + 0.055f, kLow + 0.15f, 0.085f});
}

void AirConditioner(PieceMaker& m) {
  const float half = m.Draw(0.38f, 0.45f);
  m.RoundedBox(kWhitePlastic, {-half, 0.04f, 0}, {half, 0.29f, 0.21f}, 0.03f);
  m.Quad(kDark, {-half + 0.04f, 0.02f, 0.14f}, {half - 0.04f, 0.02f, 0.14f},
         {half - 0.04f, 0.06f, 0.212f}, {-half + 0.04f, 0.06f, 0.212f});
  m.Box(kWhitePlastic, {-half, 0, 0}, {half, 0.04f, 0.13f});
  Sheet(m, kGreyPlastic, {0, 0.12f, 0.213f}, 1.8f * half, 0.008f);
  Sheet(m, {"plastic", {120, 220, 140}}, {half - 0.08f, 0.09f, 0.213f}, 0.03f, 0.012f);
}

constexpr std::array kKinds = {
    FurnitureKind{"air_conditioner", Placement::kOnWall, 0.0f, AirConditioner},
    FurnitureKind{"blind", Placement::kOnWall, 0.0f, Blind, 0.4f, 3.0f},
    FurnitureKind{"curtain", Placement::kOnWall, 0.0f, Curtain, 0.8f, 4.0f},
    FurnitureKind{"radiator", Placement::kAgainstWall, 0.1f, Radiator, 0.4f, 2.2f}};

}  // namespace

std::span<const FurnitureKind> Windows() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
