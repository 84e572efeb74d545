// SPDX-License-Identifier: MIT
#include "sim/house/materials/noise.h"

#include <array>

namespace bulletnav::sim::materials {
namespace {

/// The part of a cell's hash that its row decides; not mixed yet.
std::uint32_t RowHash(const Lattice& lattice, int y) {
  return (static_cast<std::uint32_t>(y) + 0x7F4A7C15u) * 0x85EBCA77u ^
         (lattice.seed + 0x165667B1u) * 0xC2B2AE3Du;
}
std::uint32_t Combined(std::uint32_t row_hash, int x) {
  return static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ row_hash;
}

/// A coordinate in cells: which one, brought into 0 .. n - 1, and where in it.
struct Place {
  int cell = 0;
  float in = 0.0f;
};
Place PlaceIn(float x, int n) {
  const float cells = Fraction(x) * static_cast<float>(n);
  const int cell = std::min(static_cast<int>(cells), n - 1);
  return {cell, cells - static_cast<float>(cell)};
}
int Next(int cell, int n) {
  return cell + 1 == n ? 0 : cell + 1;
}
int Previous(int cell, int n) {
  return cell == 0 ? n - 1 : cell - 1;
}

/// Dot product with one of eight directions. Only three bits of the hash are used, so a single
/// round of mixing does.
float Slope(std::uint32_t row_hash, int cell, float x, float y) {
  constexpr std::array<Point, 8> kDirections = {
      Point{1, 0}, {0.7071f, 0.7071f},   {0, 1},  {-0.7071f, 0.7071f},
      {-1, 0},     {-0.7071f, -0.7071f}, {0, -1}, {0.7071f, -0.7071f}};
  const std::uint32_t h = Combined(row_hash, cell);
  return Dot(kDirections[((h ^ (h >> 15)) * 0x2C1B3C6Du) >> 29], {x, y});
}

float Fade(float t) {
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

float Noise(Point p, const Lattice& lattice) {
  const auto [x, dx] = PlaceIn(p.x, lattice.nx);
  const auto [y, dy] = PlaceIn(p.y, lattice.ny);
  const int right = Next(x, lattice.nx);
  const std::uint32_t upper = RowHash(lattice, y);
  const std::uint32_t lower = RowHash(lattice, Next(y, lattice.ny));
  const float a = Slope(upper, x, dx, dy);
  const float b = Slope(upper, right, dx - 1.0f, dy);
  const float c = Slope(lower, x, dx, dy - 1.0f);
  const float d = Slope(lower, right, dx - 1.0f, dy - 1.0f);
  const float u = Fade(dx);
  return 1.6f * Mix(Mix(a, b, u), Mix(c, d, u), Fade(dy));
}

float Fbm(Point p, const Lattice& lattice, int octaves) {
  Lattice octave = lattice;
  float sum = 0.0f;
  float weight = 1.0f;
  float power = 0.0f;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * Noise(p, octave);
    power += weight * weight;
    weight *= 0.5f;
    octave = {2 * octave.nx, 2 * octave.ny, octave.seed + 101u};
  }
  return sum / std::sqrt(power);
}

Nearest Scatter(Point p, const Lattice& lattice, float jitter) {
  const auto [x, in_x] = PlaceIn(p.x, lattice.nx);
  const auto [y, in_y] = PlaceIn(p.y, lattice.ny);
  const std::array columns = {Previous(x, lattice.nx), x, Next(x, lattice.nx)};
  const std::array rows = {Previous(y, lattice.ny), y, Next(y, lattice.ny)};
  const float reach = jitter * 0x1.0p-16f;
  // From the middle cell's point, were it not scattered, to p.
  const float middle = 0.5f - 0.5f * jitter;
  const Point from_middle = {in_x - middle, in_y - middle};
  Nearest best{1e9f, 1e9f, 0, {}};
  for (std::size_t j = 0; j < 3; ++j) {
    const std::uint32_t row_hash = RowHash(lattice, rows[j]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t id = Hash(Combined(row_hash, columns[i]));
      const Point offset = {
          from_middle.x + 1.0f - static_cast<float>(i) - reach * static_cast<float>(id & 0xFFFFu),
          from_middle.y + 1.0f - static_cast<float>(j) - reach * static_cast<float>(id >> 16)};
      const float squared = Dot(offset, offset);
      best.second = std::min(best.second, std::max(best.first, squared));
      if (squared < best.first) best = {squared, best.second, id, offset};
    }
  }
  best.id = Hash(best.id);
  best.first = std::sqrt(best.first);
  best.second = std::sqrt(best.second);
  return best;
}

}  // namespace bulletnav::sim::materials
