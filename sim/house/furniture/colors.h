// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "sim/house/furniture/piece_maker.h"

namespace bulletnav::sim::furniture {

inline constexpr Surface kBlackPlastic{"plastic", {42, 42, 45}};
inline constexpr Surface kGreyPlastic{"plastic", {150, 152, 155}};
inline constexpr Surface kWhitePlastic{"plastic", {240, 240, 236}};
inline constexpr Surface kBlackPaint{"painted_wood", {45, 43, 42}};
inline constexpr Surface kWhitePaint{"painted_wood", {242, 240, 234}};
inline constexpr Surface kWhiteLinen{"linen", {250, 248, 243}};
inline constexpr Surface kDark{"plastic", {24, 23, 23}};  // gaps, insides, shadows
inline constexpr Surface kWhiteEnamel{"white_enamel"};
inline constexpr Surface kSteel{"brushed_steel"};
inline constexpr Surface kChrome{"chrome"};
inline constexpr Surface kBlackMetal{"black_metal"};
inline constexpr Surface kBrass{"brass"};
inline constexpr Surface kMirror{"mirror"};
inline constexpr Surface kGlass{"glass"};
inline constexpr Surface kPaper{"paper"};
inline constexpr Surface kLeaves{"leaves"};
inline constexpr Surface kSoil{"soil"};
inline constexpr Surface kWicker{"wicker"};
inline constexpr Surface kCardboard{"cardboard"};
inline constexpr Surface kRubber{"rubber", {52, 52, 54}};

/// The same material in another brightness; factors above 1 stop at white.
Surface Shaded(const Surface& surface, float factor);

/// A toy's colour.
Rgb8 BrightColor(PieceMaker& m);
/// A colour for vases, books and clothes.
Rgb8 MutedColor(PieceMaker& m);

/// One of the room's two woods, its paint, or black or white paint.
Surface FrameSurface(PieceMaker& m);

}  // namespace bulletnav::sim::furniture
