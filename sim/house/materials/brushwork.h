// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials/random.h"
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {

/// How a sketch is painted over: strokes that take up the colours under them.
struct Brush {
  int strokes = 1500;
  float length = 0.045f;
  float width = 0.014f;
  float angle = 0.0f;  // of the strokes; 0 is level
  float sway = 0.7f;   // how far they turn from it
};
void PaintOver(Canvas* canvas, const Brush& brush, Rng* rng);

/// Lines that look like writing from afar, in a box.
struct Writing {
  Box box;
  int lines = 3;
  float width = 0.006f;
  Color ink;
};
void Write(Canvas* canvas, const Writing& writing, Rng* rng);

}  // namespace bulletnav::sim::materials
