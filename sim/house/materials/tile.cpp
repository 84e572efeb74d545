// SPDX-License-Identifier: MIT
// Tiles of bathrooms, kitchens and halls.
#include "sim/house/materials/canvas.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/layout.h"

namespace bulletnav::sim::materials {
namespace {

/// How tiles are laid and finished.
struct Finish {
  Color grout;
  float joint = 0.006f;  // half the grout's width, in fractions of the picture's side
  float relief = 0.06f;  // light upper and dark lower edges of each tile
  float spread = 0.06f;  // difference in brightness between tiles
};

/// The colour of a laid tile: `tile` itself in the middle, grout at its edges.
Color Laid(Color tile, const Piece& piece, const Finish& finish) {
  const float tone = 1.0f + finish.spread * 2.0f * (Random(piece.id, 1) - 0.5f);
  const float rim = Smooth(3.0f * finish.joint, finish.joint, piece.edge);
  const float light = finish.relief * rim * (piece.at.x + piece.at.y < 1.0f ? 1.0f : -1.0f);
  const float grout = Smooth(finish.joint + 0.002f, finish.joint - 0.002f, piece.edge);
  return Mix(tile * (tone + light), finish.grout, grout);
}

/// Glazed tiles in a bond: a faint wave of the glaze over an even colour.
Image Glazed(Color color, const Bond& bond, const Finish& finish) {
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, bond);
    const Point shifted = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    const float glaze = 1.0f + 0.025f * Noise(shifted, {8, 8, bond.seed});
    return Laid(color * glaze, piece, finish);
  });
}

Image WhiteSquare() {
  return Glazed(Hex(0xf0f0ec), {6, 6, 0.0f, 1}, {Hex(0xb9b8b4), 0.007f, 0.03f, 0.02f});
}
Image WhiteSubway() {
  return Glazed(Hex(0xf2f1ed), {4, 8, 0.5f, 2}, {Hex(0xb4b3af), 0.006f, 0.035f, 0.025f});
}
Image GreenSubway() {
  return Glazed(Hex(0x6f9d86), {4, 8, 0.5f, 3}, {Hex(0xd6d8cf), 0.006f, 0.1f, 0.16f});
}
Image Black() {
  return Glazed(Hex(0x3b3b3f), {4, 4, 0.0f, 4}, {Hex(0x8b8a88), 0.006f, 0.25f, 0.12f});
}

Image BlueMosaic() {
  constexpr Color kBlues[] = {Hex(0x2f6f9f), Hex(0x4b93bf), Hex(0x7fb9d6),
                              Hex(0x9fd0df), Hex(0x3f82a8), Hex(0x5aa7c4)};
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {20, 20, 0.0f, 5});
    const Color blue = kBlues[Hash(piece.id, 8) % std::size(kBlues)];
    return Laid(blue, piece, {Hex(0xdfe6e6), 0.0055f, 0.08f, 0.08f});
  });
}

Image Checker() {
  const Field clouds(128, 128, [](Point p) {
    return Fbm(p, {5, 5, 1}, 3);
  });
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {4, 4, 0.0f, 6});
    const bool black = (static_cast<int>(p.x * 4.0f) + static_cast<int>(p.y * 4.0f)) % 2 == 1;
    const Point moved = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    const float vein = Smooth(0.12f, 0.0f, std::abs(clouds(moved)));
    const Color tile = black ? Mix(Hex(0x333338), Hex(0x4c4c52), 0.6f * vein)
                             : Mix(Hex(0xf0eee8), Hex(0xdddad3), 0.7f * vein);
    return Laid(tile, piece, {Hex(0x9f9c96), 0.0035f, 0.03f, 0.04f});
  });
}

/// Travertine: level cloudy bands and small holes, each tile cut from another place.
Image BeigeStone() {
  const Field layers(128, 128, [](Point p) {
    return Fbm(p, {4, 14, 1}, 3);
  });
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {4, 4, 0.0f, 7});
    const Point q = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    const float bands = layers(q);
    const float holes = Smooth(0.55f, 0.85f, Noise(q, {40, 90, 2})) * Smooth(-0.1f, 0.5f, bands);
    const Color stone = Mix(Hex(0xd9c6a6), Hex(0xc2a982), 0.5f + 0.45f * bands);
    return Laid(stone * (1.0f - 0.22f * holes), piece, {Hex(0xa8977b), 0.0045f, 0.03f, 0.07f});
  });
}

Image GreyLarge() {
  const Field clouds(128, 128, [](Point p) {
    return Fbm(p, {4, 4, 1}, 4);
  });
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {3, 3, 0.0f, 8});
    const Point q = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    return Laid(Hex(0xacaca8) * (1.0f + 0.05f * clouds(q)), piece,
                {Hex(0x7d7c79), 0.0035f, 0.03f, 0.045f});
  });
}

Image Slate() {
  const Field clefts(256, 256, [](Point p) {
    return Fbm(p, {7, 9, 1}, 3);
  });
  const Field stains(64, 64, [](Point p) {
    return Fbm(p, {3, 3, 2}, 2);
  });
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {3, 4, 0.5f, 9});
    const Point q = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    const float cleft = clefts(q);
    const float ledge = Smooth(0.0f, 0.12f, Fraction(1.6f * cleft)) - 0.5f;
    const float rust = Smooth(0.2f, 0.9f, stains(q) + Random(piece.id, 4) - 0.4f);
    const Color slate = Mix(Hex(0x66717a), Hex(0x5d6a63), Random(piece.id, 5));
    const Color stone = Mix(slate, Hex(0x8b7358), 0.5f * rust);
    return Laid(stone * (1.0f + 0.1f * cleft + 0.05f * ledge), piece,
                {Hex(0x9b9993), 0.0045f, 0.08f, 0.16f});
  });
}

Image Terracotta() {
  const Field clouds(128, 128, [](Point p) {
    return Fbm(p, {6, 6, 1}, 3);
  });
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {4, 4, 0.0f, 10});
    const Point q = p + Point{Random(piece.id, 2), Random(piece.id, 3)};
    const float cloud = clouds(q);
    const Color clay = Mix(Hex(0xc9744c), Hex(0xdd9a6c),
                           0.5f + 0.3f * cloud + 0.7f * (Random(piece.id, 4) - 0.5f));
    const float worn = Smooth(0.028f, 0.005f, piece.edge);
    return Laid(clay * (1.0f - 0.08f * worn), piece, {Hex(0xd3c5b0), 0.0075f, 0.04f, 0.05f});
  });
}

Image WhiteHex() {
  return Shaded([](Point p) {
    return Laid(Hex(0xefeeea), InHexagons(p, 12, 14), {Hex(0x9fa09d), 0.006f, 0.03f, 0.03f});
  });
}

/// Round tiles of 2.5 cm in dark grout, a dark one here and there.
Image Penny() {
  return Shaded([](Point p) {
    constexpr int kColumns = 16;
    Piece piece = InHexagons(p, kColumns, 18);
    piece.edge = (0.45f - Length(piece.at - Point{0.5f, 0.5f})) / static_cast<float>(kColumns);
    const Color glaze = Random(piece.id, 6) < 0.12f ? Hex(0x6b7f88) : Hex(0xe9ece8);
    return Laid(glaze, piece, {Hex(0x8d9190), 0.0015f, 0.06f, 0.04f});
  });
}

/// Printed cement tiles of 20 cm: a star in a ring, quarter rings at the corners.
Image CementPattern() {
  constexpr Color kGround = Hex(0xe6e0d2);
  constexpr Color kBlue = Hex(0x5b7488);
  constexpr Color kOchre = Hex(0xc79a5b);
  return Shaded([&](Point p) {
    const Piece piece = InBond(p, {4, 4, 0.0f, 11});
    const Point c = {std::abs(piece.at.x - 0.5f), std::abs(piece.at.y - 0.5f)};
    const float out = Length(c);
    const float corner = Length(c - Point{0.5f, 0.5f});
    // Eight-pointed star: two squares, one turned by 45 degrees.
    const float star = std::min(std::max(c.x, c.y), 0.7071f * (c.x + c.y));
    const float fade = 0.012f;
    const auto ink = [&](Color under, Color over, float distance) {
      return Mix(under, over, Smooth(fade, -fade, distance));
    };
    Color tile = ink(kGround, kBlue, std::abs(corner - 0.24f) - 0.06f);
    tile = ink(tile, kOchre, corner - 0.1f);
    tile = ink(tile, kBlue, star - 0.27f);
    tile = ink(tile, kGround, star - 0.2f);
    tile = ink(tile, kOchre, std::abs(out - 0.1f) - 0.025f);
    const float wear = 1.0f + 0.03f * Noise(p, {12, 12, 1});
    return Laid(tile * wear, piece, {Hex(0xb5b0a6), 0.0025f, 0.0f, 0.04f});
  });
}

constexpr MaterialRecipe kRecipes[] = {
    {"beige_stone_tile", MaterialFamily::kTile, 1.6f, BeigeStone},
    {"black_tile", MaterialFamily::kTile, 0.8f, Black},
    {"blue_mosaic", MaterialFamily::kTile, 0.6f, BlueMosaic},
    {"cement_pattern_tile", MaterialFamily::kTile, 0.8f, CementPattern},
    {"checker_tile", MaterialFamily::kTile, 1.2f, Checker},
    {"green_subway_tile", MaterialFamily::kTile, 0.8f, GreenSubway},
    {"grey_large_tile", MaterialFamily::kTile, 1.8f, GreyLarge},
    {"penny_tile", MaterialFamily::kTile, 0.4f, Penny},
    {"slate_tile", MaterialFamily::kTile, 1.6f, Slate},
    {"terracotta_tile", MaterialFamily::kTile, 1.2f, Terracotta},
    {"white_hex_tile", MaterialFamily::kTile, 0.6f, WhiteHex},
    {"white_square_tile", MaterialFamily::kTile, 0.8f, WhiteSquare},
    {"white_subway_tile", MaterialFamily::kTile, 0.8f, WhiteSubway},
};

}  // namespace

std::span<const MaterialRecipe> Tiles() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
