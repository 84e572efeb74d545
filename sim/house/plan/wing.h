// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "sim/house/plan/strip.h"

namespace bulletnav::sim::plan {

/// A straight corridor with a strip of rooms on one side or on both. Seen along the corridor from
/// its near end, `left` lies at negative distances and `right` beyond the corridor's width.
struct Wing {
  int corridor = -1;       // its room
  int corridor_width = 0;  // cm between middle lines
  Strip left;
  Strip right;  // no slots: the corridor runs along an outside wall there
  // Where the strips begin and how far they reach beyond the corridor's end, cm.
  int left_from = 0;
  int right_from = 0;
  int left_beyond = 0;
  int right_beyond = 0;
  bool right_may_be_short = false;  // it may end early and leave a court
  // Rooms that close the corridor's ends, lying across it and one of the strips; -1 for none.
  int near_room = -1;
  int far_room = -1;
  bool near_on_left = true;
  bool far_on_left = true;
};

/// Gives boxes to the corridor and all rooms of the wing; `axes` start at the corridor's near left
/// corner. Returns the corridor's length, or nothing if the strips cannot be made equally long.
std::optional<int> BuildWing(const Wing& wing, const Axes& axes, Draft* draft, Rng* rng);

}  // namespace bulletnav::sim::plan
