// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

/// Limits of the houses to draw. Rooms count everything: corridors and entries too.
struct PlanOptions {
  int min_rooms = 5;
  int max_rooms = 12;
  float min_area_m2 = 60.0f;
  float max_area_m2 = 200.0f;

  template <class V>
  void Visit(V& v) {
    v("min_rooms", min_rooms);
    v("max_rooms", max_rooms);
    v("min_area_m2", min_area_m2);
    v("max_area_m2", max_area_m2);
  }
  /// Throws Error unless 5 <= min_rooms <= max_rooms <= 12 and 60 <= min_area_m2, at least 15 m2 a
  /// room fit below max_area_m2 <= 200, and the limits leave a margin of 20 m2.
  void Validate() const;
};

/// Draws the layout of a one-storey home: an architect's archetype (public block with a bedroom
/// wing, corridor flat, single-loaded flat, hub, elbow, split bedrooms) with a random programme of
/// rooms is laid out in many ways, and the best of those that keep every rule is taken.
/// Frame: the world's (x, z), the footprint's centre at the origin.
/// Promises: the rooms and walls tile the footprint; every room is reachable from the entry door by
/// a body of radius 0.18 m; bedrooms open off a corridor or entry, the kitchen adjoins the dining
/// or living room, every habitable room has a window. The same rng position gives the same plan.
/// Throws: Error on bad options.  Cost: some tens of milliseconds.  Source: ours.
FloorPlan GenerateFloorPlan(const Rng& rng, const PlanOptions& options = {});

}  // namespace bulletnav::sim
