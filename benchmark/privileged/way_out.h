// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <Eigen/Core>

#include "benchmark/play/ground_truth.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// A way that the physics lets the body go, in steps of one forward move, from where the navmesh's
/// way is blocked by something it is too coarse to know, to where its way to the goal is at least
/// half a metre shorter. Best-first search over headings 20 degrees apart. Empty if there is none
/// nearby. Cost: up to a second; rare.
std::vector<Eigen::Vector3d> FindWayOut(const GroundTruth& truth, const sim::NavmeshQuery& query);

}  // namespace bulletnav::bench
