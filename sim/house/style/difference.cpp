// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "sim/house/house_style.h"
#include "sim/house/style/tint.h"

namespace bulletnav::sim {
namespace {

// Two materials are told apart by their patterns even if their colours are near.
constexpr double kOtherFamily = 25.0;
constexpr double kOtherMaterial = 10.0;

double SurfaceDifference(const Surface& a, const Surface& b) {
  const double color = style::ColorDistance(a.tint, b.tint);
  if (a.material == b.material) return color;
  const bool same_family = FindMaterial(a.material).family == FindMaterial(b.material).family;
  return std::max(color, same_family ? kOtherMaterial : kOtherFamily);
}

const Surface& At(const WallFinish& wall, float height) {
  return height < wall.split ? wall.lower : wall.upper;
}

double WallDifference(const WallFinish& a, const WallFinish& b) {
  constexpr std::array kHeights = {0.4f, 1.0f, 1.5f, 2.1f};
  double sum = 0.0;
  for (const float height : kHeights) sum += SurfaceDifference(At(a, height), At(b, height));
  return sum / static_cast<double>(kHeights.size());
}

double PaletteDifference(const Palette& a, const Palette& b) {
  return 0.25 * (SurfaceDifference(a.wood, b.wood) + SurfaceDifference(a.fabric, b.fabric) +
                 SurfaceDifference(a.accent, b.accent) + SurfaceDifference(a.rug, b.rug));
}

}  // namespace

double Difference(const RoomStyle& a, const RoomStyle& b) {
  constexpr double kAccentPart = 0.25;  // of the walls
  const bool has_accent = a.accent_edge >= 0 || b.accent_edge >= 0;
  const double part = has_accent ? kAccentPart : 0.0;
  const double accent = WallDifference(a.accent_edge >= 0 ? a.accent : a.walls,
                                       b.accent_edge >= 0 ? b.accent : b.walls);
  const double walls = (1.0 - part) * WallDifference(a.walls, b.walls) + part * accent;
  return 0.6 * walls + 0.25 * SurfaceDifference(a.floor, b.floor) +
         0.15 * PaletteDifference(a.palette, b.palette);
}

}  // namespace bulletnav::sim
