// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/materials/field.h"
#include "sim/house/materials/random.h"
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {

/// Things that landscapes are made of, in paintings and behind windows.

/// A sky with clouds, fading towards the horizon.
class Sky {
 public:
  /// `skyline` is the horizon's y; `cover` 0 a clear sky, 1 a cloudy one.
  Sky(Color zenith, Color horizon, float skyline, float cover);
  Color operator()(Point p) const;

 private:
  Color zenith_;
  Color horizon_;
  float skyline_;
  float cover_;
  Field clouds_;
};

/// The outline of hills: y as a function of x, between `base` and about `rise` above it.
class Ridge {
 public:
  Ridge(float base, float rise, std::uint32_t seed);
  float operator()(float x) const;
  /// What is seen at p: `under` above the outline, `over` below it.
  Color Cover(Point p, Color under, Color over) const;

 private:
  std::vector<float> heights_;
};

/// A broad-leaved tree standing at `foot`.
void PaintTree(Canvas* canvas, Point foot, float height, Color leaves, Rng* rng);

/// A house front with a door, windows and a gable, its ground floor's left corner at `foot`.
struct HouseLook {
  Point foot;
  float width = 0.3f;
  float height = 0.25f;  // of the wall
  Color wall;
  Color roof;
  Color door;
};
void PaintHouse(Canvas* canvas, const HouseLook& house);

}  // namespace bulletnav::sim::materials
