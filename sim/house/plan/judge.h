// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "sim/house/floor_plan_generator.h"
#include "sim/house/plan/draft.h"

namespace bulletnav::sim::plan {

/// A draft whose geometry keeps the rules, with its borders.
struct Layout {
  Draft draft;
  std::vector<Border> borders;
  double penalty = 0.0;  // the lower the better

  /// Longest clear stretch of wall between two rooms (kOutside for one), metres; 0 if none.
  float SharedWall(int a, int b) const;
};

/// Checks what an architect would not accept: sizes, proportions, dark rooms, a kitchen away from
/// the table, bathrooms away from the beds, niches. Returns nothing for bad drafts and rates the
/// others by how well sizes, zones and circulation work out.
std::optional<Layout> Judge(const Draft& draft, const PlanOptions& options);

/// Clear floor of a room, m2.
float ClearArea(const Draft& draft, int room);

}  // namespace bulletnav::sim::plan
