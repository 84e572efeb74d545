// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {

/// Brightness of threads and loops, around 1; all repeat with the picture.

/// Plain weave of so many threads a side (even): each passes over one and under the next.
inline float PlainWeave(Point p, int threads) {
  const float x = p.x * static_cast<float>(threads);
  const float y = p.y * static_cast<float>(threads);
  const bool over = (Floor(x) + Floor(y)) % 2 == 0;
  const float round = over ? Wave(y) : Wave(x);
  return 0.88f + 0.16f * round * (over ? 1.0f : 0.85f);
}

/// Diagonal ribs, `ribs` across the picture.
inline float Twill(Point p, int ribs) {
  return 0.95f + 0.1f * Wave(static_cast<float>(ribs) * (p.x + p.y));
}

/// Threads of uneven thickness both ways, as in linen; mean 1, `strength` their contrast.
inline float Slubs(Point p, float strength, std::uint32_t seed) {
  return 1.0f + strength * (Noise(p, {110, 7, seed}) + Noise(p, {7, 110, seed + 1u}));
}

/// Stocking stitch: columns of V, `rows` of them one above another.
inline float Stitches(Point p, int columns, int rows) {
  const float x = Fraction(p.x * static_cast<float>(columns));
  const float lean = std::abs(x - 0.5f);
  const float strand = Wave(p.y * static_cast<float>(rows) + 1.5f * lean);
  const float side = Wave(2.0f * x);
  return 0.7f + 0.32f * (0.25f + 0.75f * strand) * (0.35f + 0.65f * side);
}

/// Loops in staggered rows; `columns` and `rows` (even) of them.
inline float Loops(Point p, int columns, int rows) {
  const float y = p.y * static_cast<float>(rows);
  const float x = p.x * static_cast<float>(columns) + (Floor(y) % 2 == 0 ? 0.0f : 0.5f);
  return 0.72f + 0.32f * Wave(x) * Wave(y) + 0.06f * (0.5f - Fraction(y));
}

/// Short wool pile of a patterned rug.
inline float WoolPile(Point p) {
  return 1.0f + 0.05f * Noise(p, {128, 128, 71}) + 0.04f * Noise(p, {3, 40, 72});
}

}  // namespace bulletnav::sim::materials
