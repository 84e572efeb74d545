// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {

inline constexpr float kWorktop = 0.9f;  // height of every kitchen run
inline constexpr float kWorktopThick = 0.04f;
inline constexpr float kUnitDepth = 0.58f;  // of base units; the worktop stands out a bit
inline constexpr float kWorktopDepth = 0.61f;
inline constexpr float kKick = 0.1f;       // height of the plinth
inline constexpr float kWallUnit = 1.45f;  // wall cabinets hang from here
inline constexpr float kWallUnitTop = 2.15f;
inline constexpr float kWallUnitDepth = 0.34f;

/// Where a part of a kitchen lies along the wall.
struct Along {
  float x0 = 0.0f;
  float x1 = 0.0f;
  float width() const { return x1 - x0; }
  float middle() const { return 0.5f * (x0 + x1); }
};

/// Plinth and body of base units, without fronts and worktop.
void BaseBody(PieceMaker& m, const Along& along);
/// Base units with fronts for their width.
void BaseUnits(PieceMaker& m, const Along& along);
void WallUnits(PieceMaker& m, const Along& along, float bottom = kWallUnit);
void PlainWorktop(PieceMaker& m, const Along& along);
/// Tiled wall above the worktop up to `top`.
void Backsplash(PieceMaker& m, const Along& along, float top);

/// Backsplash and wall cabinets, as far as they fit under the height asked for.
void AboveWorktop(PieceMaker& m, const Along& along);

/// A pot with two handles and a lid.
void CookingPot(PieceMaker& m, const Vec& at, float radius, float height);
/// A microwave oven standing at `at`, its back at at.z.
void MicrowaveOven(PieceMaker& m, const Vec& at);

}  // namespace bulletnav::sim::furniture
