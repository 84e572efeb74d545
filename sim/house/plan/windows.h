// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "sim/house/plan/judge.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// What the windows of one house have in common.
struct WindowStyle {
  float head = 2.15f;     // upper edge of all windows above the floor, metres
  float scale = 1.0f;     // of widths
  float low_sill = 0.0f;  // how much lower sills are than usual
  double terrace_chance = 0.5;
  bool is_flat = false;  // neighbours on one or two sides: no windows there
};

/// Windows of every room that has an outside wall, by room type: centred on the wall or in even
/// rows, heads in one line, clear of corners and of the entry door among `doors`. Rooms that need
/// daylight always get some. Coordinates: the draft's in metres.
std::vector<Opening> PlaceWindows(const Layout& layout, const std::vector<Opening>& doors,
                                  const WindowStyle& style, Rng* rng);

}  // namespace bulletnav::sim::plan
