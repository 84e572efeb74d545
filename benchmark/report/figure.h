// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "benchmark/report/canvas.h"

namespace bulletnav::bench {

/// A drawing that can be had as vectors and as pixels.
struct Figure {
  int width = 0;  // units of the canvas
  int height = 0;
  std::function<void(Canvas*)> draw;  // may be called more than once
};

/// Two pixels a unit, unless told.
sim::Image ToImage(const Figure& figure, double scale = 2.0);
std::string ToSvg(const Figure& figure);

/// Writes STEM.svg and STEM.png, atomically. Throws sim::FileError.
void WriteFigure(const Figure& figure, const std::filesystem::path& stem);

}  // namespace bulletnav::bench
