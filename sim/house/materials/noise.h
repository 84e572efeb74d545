// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/house/materials/color.h"

namespace bulletnav::sim::materials {

/// Mixes up to three whole numbers; cheap enough to call for every pixel.
constexpr std::uint32_t Hash(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
  std::uint32_t h =
      a * 0x9E3779B1u ^ (b + 0x7F4A7C15u) * 0x85EBCA77u ^ (c + 0x165667B1u) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}
/// In [0, 1), a function of its arguments.
constexpr float Random(std::uint32_t a, std::uint32_t b = 0) {
  return static_cast<float>(Hash(a, b) >> 8) * 0x1.0p-24f;
}

/// A grid of nx by ny cells laid over the picture; noise made from it repeats with the picture.
/// More cells along one axis than along the other make streaks along the other.
struct Lattice {
  int nx = 1;
  int ny = 1;
  std::uint32_t seed = 0;
};

/// Gradient noise: mean 0, most of it within -1 to 1, features of about a cell.
float Noise(Point p, const Lattice& lattice);
/// Noise plus finer noise at half the size and half the strength, and so on; scaled as Noise.
float Fbm(Point p, const Lattice& lattice, int octaves);
/// The two nearest of one point scattered in each cell. Distances in cells.
struct Nearest {
  float first = 0.0f;
  float second = 0.0f;
  std::uint32_t id = 0;  // of the nearest, the same across the seam
  Point offset;          // from the nearest to p, in cells
};
/// `jitter` 0 puts the points in the middle of the cells, 1 anywhere in them.
Nearest Scatter(Point p, const Lattice& lattice, float jitter = 1.0f);

}  // namespace bulletnav::sim::materials
