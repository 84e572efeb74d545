// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/furniture/colors.h"

namespace bulletnav::sim::furniture {

inline constexpr float kQuarterTurn = 1.57079633f;

/// A frame at `at`, turned about y, then about its x (positive: its top leans to the front), then
/// about its z. Radians.
Eigen::Affine3f Turned(const Vec& at, float yaw, float pitch = 0.0f, float roll = 0.0f);

/// Places `pitch` apart from `low` on, below `high`.
std::vector<float> Spaced(float low, float high, float pitch);

/// A frame at the origin that stretches what is in it, each axis by up to `share` up or down.
Eigen::Affine3f Stretched(PieceMaker& m, float share);

/// Square post without a bottom, standing at `bottom`: 10 triangles.
void Post(PieceMaker& m, const Surface& surface, const Vec& bottom, float thickness, float height);
/// Box without back and bottom: parts whose back is hidden; 8 triangles.
void Panel(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high);
/// Box with slanted upper edges and no bottom: flat cushions and mattresses; 18 triangles.
void Cushion(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high, float bevel);
/// Cushion that is thick in its middle and thin at its edges; 20 triangles.
void Pillow(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high);
/// The inside of an open box: four walls that look inwards and a floor, which is `slant` narrower
/// on every side than the opening.
void Hollow(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high,
            float slant = 0.0f);
/// Level disc that faces up.
void Disc(PieceMaker& m, const Surface& surface, const Vec& centre, float radius, int sides = 12);
/// The same with the middle of the material's picture in its middle: mirrors, round rugs.
void PictureDisc(PieceMaker& m, const Surface& surface, const Vec& centre, float radius, int sides);
/// Upright picture of given size whose lower edge is centred on `low`, looking to the front.
void Sheet(PieceMaker& m, const Surface& surface, const Vec& low, float width, float height);
/// One of the photographs of the material that shows a wall of them, in the same way.
void FamilyPhoto(PieceMaker& m, const Vec& low, float width, float height);
/// Wheel or hoop standing across x, its centre at `centre`, of straight pieces.
void Hoop(PieceMaker& m, const Surface& surface, const Vec& centre, float radius, float thickness,
          int pieces = 10);

enum class LegStyle { kSquare, kTapered, kRound, kSplayed };
LegStyle DrawLegStyle(PieceMaker& m);

/// Four legs under the rectangle from `low` to `high` (x, z), from the floor to `height`.
struct LegSet {
  LegStyle style = LegStyle::kSquare;
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  float height = 0.7f;
  float thickness = 0.05f;
};
void Legs(PieceMaker& m, const Surface& surface, const LegSet& legs);

/// A field of the front of a cabinet, looking to +z.
struct FrontField {
  float x0 = 0.0f;
  float x1 = 0.0f;
  float y0 = 0.0f;
  float y1 = 0.0f;
  float z = 0.0f;
};
enum class HandleAt { kTop, kMiddle, kBottom };  // where along a door's opening edge

/// Doors side by side, opening in pairs.
void Doors(PieceMaker& m, const Surface& surface, const FrontField& field, int count,
           HandleAt handle = HandleAt::kMiddle);
/// One drawer, or rows of them.
void Drawers(PieceMaker& m, const Surface& surface, const FrontField& field, int rows);
/// Box whose front shows dark gaps between what is put on it: the body of a cabinet.
void Body(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high);
/// Box open to the front: sides, top, bottom and a darker back.
void OpenBody(PieceMaker& m, const Surface& surface, const Vec& low, const Vec& high,
              float thickness);

/// A row of books whose spines are about at the front of the box from `low` to `high`; leaves gaps.
void Books(PieceMaker& m, const Vec& low, const Vec& high);
/// Something to put on a shelf or sideboard that fits into `size` (x, y, z), standing at `at`.
void Ornament(PieceMaker& m, const Vec& at, const Vec& size);
/// Water tap standing at `at`, its spout reaching `reach` to the front.
void Tap(PieceMaker& m, const Vec& at, float height, float reach);
/// Leaf or petal: a bent diamond from `base` along `along` (its length) of the given width.
void Leaf(PieceMaker& m, const Surface& surface, const Vec& base, const Vec& along, float width);

}  // namespace bulletnav::sim::furniture
