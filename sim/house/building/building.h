// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/house/building/building_plan.h"
#include "sim/house/building/kind.h"
#include "sim/house/house.h"

namespace bulletnav::sim::building {

/// Draws a building from its kind and seed. Frame: the world's, the floor at y = 0, about the
/// origin. The same kind, seed and limits give the same building to the last bit on every machine.
/// `textures`: pictures to share between calls; one per thread. Cost: seconds for each 100 m2.
/// Throws Error as GenerateBuildingPlan.
House GenerateBuilding(const BuildingKind& kind, std::uint64_t seed, TextureCache* textures,
                       const AreaLimits& limits = {}, const Refurnish& refurnish = {});

}  // namespace bulletnav::sim::building
