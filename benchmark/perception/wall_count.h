// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>

#include "sim/physics/physics_world.h"

namespace bulletnav::bench {

/// Number of walls between two places on one storey's floor, as a straight line crosses them.
/// What blocks the line 1.95 m above the floor, below the lintels of doors (2.05 m), and also
/// 2.32 m above it or just below a lower ceiling, over furniture and doors that stand open, is a
/// wall. Surfaces less than 0.4 m apart are one wall. A line through an open door crosses none,
/// through a shut one a wall. Where ceilings are lower than 2 m, tall furniture counts as well.
/// Cost: some tens of microseconds.
int WallsBetween(const sim::PhysicsWorld& scene, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& to);

}  // namespace bulletnav::bench
