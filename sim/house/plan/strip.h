// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/plan/draft.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// What takes one stretch of a strip: a room, or two rooms that share it.
struct Slot {
  int room = -1;
  int behind = -1;          // a second room between this one and the outside wall
  int notch = -1;           // a second room cut from this one's corner at the corridor
  bool notch_first = true;  // at the stretch's beginning, else at its end
  int porch_cm = 0;         // how far it stays back from the outside wall
};

/// A row of rooms along one side of a corridor.
struct Strip {
  int depth = 0;  // cm, away from the corridor
  std::vector<Slot> slots;
};

/// How long a row may be, cm.
struct Span {
  int low = 0;
  int want = 0;
  int high = 0;

  bool empty() const { return low > high; }
};

/// What one slot and what a whole strip can take up along the corridor; empty if the depth is
/// wrong.
Span SlotSpan(const Draft& draft, const Slot& slot, int depth);
Span StripSpan(const Draft& draft, const Strip& strip);

/// Turns strip coordinates (cm along the corridor, cm away from it) into the draft's.
struct Axes {
  GridPoint origin;
  GridPoint along;  // unit steps
  GridPoint out;

  Box At(int s0, int d0, int s1, int d1) const;
};

/// Gives the slots' rooms their boxes so that they fill `length` exactly.
/// Expects: a length within the strip's span (checked).
void FillStrip(const Strip& strip, const Axes& frame, int length, Draft* draft, Rng* rng);

}  // namespace bulletnav::sim::plan
