// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "sim/house/floor_plan_generator.h"

namespace bulletnav::sim {

/// The plans of seeds 0 to count - 1.
inline std::vector<FloorPlan> SamplePlans(int count) {
  std::vector<FloorPlan> plans;
  for (int seed = 0; seed < count; ++seed) {
    plans.push_back(GenerateFloorPlan(Rng(static_cast<std::uint64_t>(seed), "plan_test")));
  }
  return plans;
}

}  // namespace bulletnav::sim
