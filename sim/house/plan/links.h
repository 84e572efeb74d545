// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "sim/house/plan/judge.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// Two rooms, or a room and the outside, that shall be joined by a door or an arch.
struct Link {
  int a = -1;
  int b = kOutside;
  OpeningKind kind = OpeningKind::kDoor;
};

/// Clear wall a door with its casing and corner gaps needs, metres.
inline constexpr float kDoorWall = 1.06f;

/// Decides who is joined to whom: a tree that reaches every room by what architects prefer
/// (bedrooms off corridors, an en-suite off its bedroom, dining between living and kitchen), some
/// loops, and the entry door, which comes last. `openness` in [0, 1]: how readily a doorway is an
/// open arch. Nothing if some room cannot be reached decently.
std::optional<std::vector<Link>> DrawLinks(const Layout& layout, double openness, Rng* rng);

}  // namespace bulletnav::sim::plan
