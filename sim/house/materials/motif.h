// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {

/// Ornaments painted in flat colours, for wallpapers, fabrics, rugs and pictures.

struct FlowerLook {
  int petals = 5;
  Color petal;
  Color heart;
};
/// A flower seen from the front.
void PaintFlower(Canvas* canvas, Point centre, float radius, float angle, const FlowerLook& look);

/// A stem from `root` to `tip` with leaflets in pairs, longest in the middle.
void PaintFrond(Canvas* canvas, Point root, Point tip, int pairs, Color color);

/// A symmetric ornament of acanthus leaves, `height` tall and about half as wide.
void PaintDamask(Canvas* canvas, Point centre, float height, Color color);

}  // namespace bulletnav::sim::materials
