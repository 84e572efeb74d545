// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <recastnavigation/Recast.h>

namespace bulletnav::sim {

/// What lies over and under a walkable place; one for each span of a compact heightfield, in its
/// order.
struct Surroundings {
  bool is_covered = false;   // something is overhead, at any height
  bool is_upstairs = false;  // a body can stand in the same column below
  bool is_enclosed = false;  // a building around: most ways out lead through it
  bool is_indoors() const { return is_covered || is_enclosed; }
};

/// Looks at each walkable span of a filtered heightfield, of which the compact one is made. Of 16
/// directions 11, more than outside the corner of a building, must lead to, or below, something
/// that reaches a body's height above the span: walls, and what spans doorways and open fronts.
/// Cost: 16 sweeps over the grid if anything is uncovered, else next to nothing. Source: ours.
std::vector<Surroundings> LookAround(const rcHeightfield& heights,
                                     const rcCompactHeightfield& compact);

/// Makes what is not indoors unwalkable. Nothing, and returns false, if less than 4 m2 or a
/// hundredth of all that is walkable is indoors: such scenes are open.
bool KeepIndoors(const std::vector<Surroundings>& surroundings, rcCompactHeightfield* compact);

}  // namespace bulletnav::sim
