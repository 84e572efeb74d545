// SPDX-License-Identifier: MIT
#include "sim/house/furniture/colors.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim::furniture {

Surface Shaded(const Surface& surface, float factor) {
  Surface shaded = surface;
  for (std::uint8_t& channel : shaded.tint) {
    const float value = std::round(static_cast<float>(channel) * factor);
    channel = static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f));
  }
  return shaded;
}

Rgb8 BrightColor(PieceMaker& m) {
  static constexpr std::array<Rgb8, 7> kColors = {
      Rgb8{222, 56, 48},  Rgb8{246, 196, 45}, Rgb8{48, 128, 210}, Rgb8{70, 170, 80},
      Rgb8{240, 130, 40}, Rgb8{150, 90, 190}, Rgb8{235, 120, 160}};
  return m.rng().Pick(kColors);
}

Rgb8 MutedColor(PieceMaker& m) {
  static constexpr std::array<Rgb8, 9> kColors = {
      Rgb8{62, 92, 122},  Rgb8{150, 70, 58},   Rgb8{96, 122, 88},
      Rgb8{206, 168, 98}, Rgb8{196, 190, 178}, Rgb8{92, 74, 102},
      Rgb8{70, 66, 64},   Rgb8{190, 120, 84},  Rgb8{120, 160, 164}};
  return m.rng().Pick(kColors);
}

Surface FrameSurface(PieceMaker& m) {
  const Palette& palette = m.palette();
  const std::array<Surface, 5> kinds = {palette.wood, palette.other_wood, palette.cabinet,
                                        kBlackPaint, kWhitePaint};
  return m.rng().Pick(kinds);
}

}  // namespace bulletnav::sim::furniture
