// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {

/// Where a point of a laid surface lies: in which tile, brick, board or stone. Every layout here
/// repeats with the picture.
struct Piece {
  std::uint32_t id = 0;  // random, the same all over the piece, also across the seam
  Point at;              // 0 to 1 along and across it; along is its longer side
  float edge = 0.0f;     // distance to its nearest edge in fractions of the picture's side
  bool turned = false;   // its longer side runs down the picture
};

/// Rows of equal pieces; every other row moved along by `shift` of a piece (then `rows` is even).
struct Bond {
  int columns = 4;
  int rows = 4;
  float shift = 0.0f;
  std::uint32_t seed = 0;
};
Piece InBond(Point p, const Bond& bond);

/// Boards along x in rows, their joints at random places.
class Boards {
 public:
  Boards(int rows, int per_row, std::uint32_t seed);
  Piece operator()(Point p) const;

 private:
  /// Board i of a row reaches from start i to start i + 1, in boards, after a shift of the row.
  struct Board {
    float start = 0.0f;
    float length = 0.0f;
    std::uint32_t id = 0;
  };
  int rows_;
  int per_row_;
  std::vector<float> shifts_;
  std::vector<Board> boards_;
};

/// Blocks `ratio` times as long as wide in zigzags at 45 degrees to the picture's axes. A block is
/// 1 / (sqrt(2) repeats) of the picture's side long.
Piece InHerringbone(Point p, int repeats, int ratio);

/// Squares of `strips` parallel strips, turned in alternate squares; `squares` a side, even.
Piece InBasket(Point p, int squares, int strips);

/// Regular hexagons in rows, one pointing up; rows even, about 1.15 times as many as columns.
Piece InHexagons(Point p, int columns, int rows);

/// Irregular stones, about nx by ny of them.
Piece InRubble(Point p, const Lattice& lattice, float jitter);

}  // namespace bulletnav::sim::materials
