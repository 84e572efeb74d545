// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/walk_grid.h"
#include "sim/math/pose.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// Draws config.points places where the body can stand, evenly over a storey's floor, and a heading
/// for each. Place i depends on the config's seed, the scene's name and i alone. Throws sim::Error
/// if there is hardly a place to stand.
std::vector<sim::BodyPose> DrawPoints(const sim::World& world, const Storey& storey,
                                      const DataConfig& config);

}  // namespace bulletnav::bench
