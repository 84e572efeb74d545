// SPDX-License-Identifier: MIT
#include "sim/house/materials/layout.h"

namespace bulletnav::sim::materials {
namespace {

/// Distance to the nearest side of a rectangle of a given size, at `at` (0 to 1) inside it.
float ToSide(Point at, Point size) {
  return std::min(std::min(at.x, 1.0f - at.x) * size.x, std::min(at.y, 1.0f - at.y) * size.y);
}

std::uint32_t IdOf(int a, int b, std::uint32_t seed = 0) {
  return Hash(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), seed);
}

}  // namespace

Piece InBond(Point p, const Bond& bond) {
  const float y = p.y * static_cast<float>(bond.rows);
  const int row = Floor(y);
  const float moved = Modulo(row, 2) == 1 ? bond.shift : 0.0f;
  const float x = p.x * static_cast<float>(bond.columns) + moved;
  Piece piece;
  piece.at = {Fraction(x), Fraction(y)};
  piece.id = IdOf(Modulo(Floor(x), bond.columns), Modulo(row, bond.rows), bond.seed);
  piece.edge = ToSide(
      piece.at, {1.0f / static_cast<float>(bond.columns), 1.0f / static_cast<float>(bond.rows)});
  return piece;
}

Boards::Boards(int rows, int per_row, std::uint32_t seed) : rows_(rows), per_row_(per_row) {
  const auto start = [&](std::uint32_t row_id, int i) {
    const auto wrapped = static_cast<std::uint32_t>(Modulo(i, per_row));
    return static_cast<float>(i) + 0.5f * (Random(row_id, wrapped + 7u) - 0.5f);
  };
  for (int row = 0; row < rows; ++row) {
    const std::uint32_t row_id = IdOf(row, 0, seed);
    shifts_.push_back(Random(row_id));
    for (int i = 0; i < per_row; ++i) {
      const float from = start(row_id, i);
      boards_.push_back({from, start(row_id, i + 1) - from, IdOf(row, i, seed + 1u)});
    }
  }
}

Piece Boards::operator()(Point p) const {
  const float y = Fraction(p.y) * static_cast<float>(rows_);
  const int row = std::min(static_cast<int>(y), rows_ - 1);
  const Board* boards =
      &boards_[static_cast<std::size_t>(row) * static_cast<std::size_t>(per_row_)];
  const float n = static_cast<float>(per_row_);
  float x = Fraction(p.x + shifts_[static_cast<std::size_t>(row)]) * n;
  int i = std::min(static_cast<int>(x), per_row_ - 1);
  if (x < boards[i].start) {
    // The last board may reach over the end of the row.
    if (i == 0) x += n;
    i = i == 0 ? per_row_ - 1 : i - 1;
  } else if (x >= boards[i].start + boards[i].length) {
    if (i == per_row_ - 1) x -= n;
    i = i == per_row_ - 1 ? 0 : i + 1;
  }
  const Board& board = boards[i];
  Piece piece;
  piece.at = {(x - board.start) / board.length, y - static_cast<float>(row)};
  piece.id = board.id;
  piece.edge = ToSide(piece.at, {board.length / n, 1.0f / static_cast<float>(rows_)});
  return piece;
}

Piece InHerringbone(Point p, int repeats, int ratio) {
  // On a grid of unit cells at 45 degrees, cells on one diagonal belong to blocks the same way:
  // with d = (i - j) mod 2 ratio, d < ratio is place d of a block along a, the others lie along b.
  // One picture is (n, n) and (n, -n) of these cells, so n is a multiple of the ratio.
  const int n = repeats * ratio;
  const float a = (p.x + p.y) * static_cast<float>(n);
  const float b = (p.x - p.y) * static_cast<float>(n);
  int i = Floor(a);
  int j = Floor(b);
  const int d = Modulo(i - j, 2 * ratio);
  const bool turned = d >= ratio;
  const int place = turned ? 2 * ratio - 1 - d : d;
  const float r = static_cast<float>(ratio);
  Piece piece;
  piece.turned = turned;
  piece.at = turned ? Point{(static_cast<float>(place) + Fraction(b)) / r, Fraction(a)}
                    : Point{(static_cast<float>(place) + Fraction(a)) / r, Fraction(b)};
  (turned ? j : i) -= place;
  const int wraps = Modulo(i, 2 * n) >= n ? n : 0;
  piece.id = IdOf(Modulo(i - wraps, 2 * n), Modulo(j - wraps, 2 * n));
  const float cell = 1.0f / (std::numbers::sqrt2_v<float> * static_cast<float>(n));
  piece.edge = ToSide(piece.at, {r * cell, cell});
  return piece;
}

Piece InBasket(Point p, int squares, int strips) {
  const Point q = p * static_cast<float>(squares);
  const int i = Modulo(Floor(q.x), squares);
  const int j = Modulo(Floor(q.y), squares);
  Piece piece;
  piece.turned = (i + j) % 2 == 1;
  Point in = {Fraction(q.x), Fraction(q.y)};
  if (piece.turned) std::swap(in.x, in.y);
  const float n = static_cast<float>(strips);
  const int strip = std::min(Floor(in.y * n), strips - 1);
  piece.at = {in.x, Fraction(in.y * n)};
  piece.id = IdOf(i * strips + strip, j, 5u);
  const float side = 1.0f / static_cast<float>(squares);
  piece.edge = ToSide(piece.at, {side, side / n});
  return piece;
}

Piece InHexagons(Point p, int columns, int rows) {
  // The nearest centres are in this row or the two beside it. Rows are brought to their true
  // distance of sqrt(3) / 2 columns.
  constexpr float kRow = 0.8660254f;
  const Point q = {p.x * static_cast<float>(columns), p.y * static_cast<float>(rows)};
  const int row = Floor(q.y);
  float first = 1e9f;
  float second = 1e9f;
  Piece piece;
  for (int k = 0; k < 6; ++k) {
    const int j = row - 1 + k / 2;
    const float moved = Modulo(j, 2) == 1 ? 0.5f : 0.0f;
    // Of one row, the two centres on either side of p.
    const int i = Round(q.x - moved) - 1 + k % 2;
    const Point offset = {q.x - moved - static_cast<float>(i) - 0.5f,
                          (q.y - static_cast<float>(j) - 0.5f) * kRow};
    const float squared = Dot(offset, offset);
    if (squared < first) {
      second = first;
      first = squared;
      piece.at = offset + Point{0.5f, 0.5f};
      piece.id = IdOf(Modulo(i, columns), Modulo(j, rows), 9u);
    } else {
      second = std::min(second, squared);
    }
  }
  // Centres are one column apart: the border is where the squares of the distances are equal.
  piece.edge = 0.5f * (second - first) / static_cast<float>(columns);
  return piece;
}

Piece InRubble(Point p, const Lattice& lattice, float jitter) {
  const Nearest nearest = Scatter(p, lattice, jitter);
  Piece piece;
  piece.id = nearest.id;
  piece.at = nearest.offset + Point{0.5f, 0.5f};
  piece.edge = 0.5f * (nearest.second - nearest.first) /
               static_cast<float>(std::max(lattice.nx, lattice.ny));
  return piece;
}

}  // namespace bulletnav::sim::materials
