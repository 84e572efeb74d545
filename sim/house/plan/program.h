// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/floor_plan_generator.h"
#include "sim/house/plan/draft.h"

namespace bulletnav::sim::plan {

/// The rooms a household asks for.
struct Program {
  double size = 0.5;             // 0 a small flat, 1 a large house
  std::vector<DraftRoom> rooms;  // without boxes

  bool Has(RoomType type) const;
  /// First room of a type, -1 if there is none.
  int Find(RoomType type) const;
};

/// Draws a programme: living room, kitchen, bathroom, a bedroom and a corridor, then what fits the
/// size: dining room, more bedrooms, kids' rooms, study, second bathroom...
Program DrawProgram(const PlanOptions& options, Rng* rng);

}  // namespace bulletnav::sim::plan
