// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "sim/house/plan/judge.h"
#include "sim/house/plan/links.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// What the holes of one house have in common.
struct DoorStyle {
  float arch_top = 2.2f;
  float door_top = 2.05f;
  float widest_arch = 2.4f;
  float widest_hall_arch = 1.6f;  // into corridors and other halls
};

/// Where along a wall an opening may lie: a border with its hole, draft centimetres as metres.
/// Walking from a to b, `room` is to the left; on outside walls a and b lie on the thicker wall's
/// middle line.
Opening MakeOpening(const Draft& draft, const Border& border, int room, float from, float to);

/// Puts every link's door or arch into a wall the two share: doors near a corner of the room they
/// open into, leaves along the wall there, arches in the middle. Leaves stay clear of each other
/// and of the ways through other openings. Nothing if that cannot be done. Coordinates: the draft's
/// in metres.
std::optional<std::vector<Opening>> PlaceDoors(const Layout& layout, const std::vector<Link>& links,
                                               const DoorStyle& style, Rng* rng);

}  // namespace bulletnav::sim::plan
