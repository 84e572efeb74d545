// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "sim/house/plan/draft.h"
#include "sim/house/plan/program.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::plan {

/// How circulation holds a home together.
enum class Archetype {
  kBlockWing,  // living block at the end of a corridor with rooms on both sides
  kFlat,       // everything off one corridor, the living room across or beside its end
  kGallery,    // rooms on one side of the corridor only
  kHub,        // a short wide hall in the middle
  kElbow,      // a corridor that turns a corner: L and U shapes
  kSplit       // living block in the middle, a wing of bedrooms on either side
};

/// Choices that stay while sizes and orders are tried.
struct Traits {
  Archetype archetype = Archetype::kBlockWing;
  int wall_cm = 12;
  int outer_cm = 24;
  float corridor_m = 1.25f;   // clear width
  bool has_far_room = false;  // a bedroom closes the corridor's end
  bool has_court = false;     // one strip ends early
  bool has_branch = false;    // without an entry room: the corridor itself reaches the outside wall
  bool has_porch = false;     // the entry stays back from the outside wall
  bool has_long_block = false;  // the living block stands out from the wing
};

Traits DrawTraits(const Program& program, const PlanOptions& options, Rng* rng);

/// One try at laying the programme out; nothing if the sizes do not work out. What comes back has
/// boxes for all rooms but may still break rules (see Judge).
std::optional<Draft> DrawDraft(const Program& program, const Traits& traits, Rng* rng);

}  // namespace bulletnav::sim::plan
