// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/math/rng.h"

namespace bulletnav::sim {

/// Some rooms of a building furnished anew, as if years had passed: their furniture is drawn again.
/// Walls, doors, colours of walls and floors and all other rooms stay.
struct Refurnish {
  double share = 0.0;      // of the rooms, 0 to 1
  std::uint64_t seed = 1;  // which ones, and with what

  bool operator==(const Refurnish&) const = default;

  template <class V>
  void Visit(V& v) {
    v("share", share);
    v("seed", seed);
  }
  /// Throws KeyError.
  void Validate() const;
};

/// What each room's furniture is drawn with: `rng`, but another one for the share that is furnished
/// anew, which is rounded, and one room at least where it is above 0.
std::vector<Rng> RoomRngs(const Rng& rng, int rooms, const Refurnish& refurnish);

}  // namespace bulletnav::sim
