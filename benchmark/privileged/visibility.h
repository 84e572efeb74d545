// SPDX-License-Identifier: MIT
#pragma once
#include "sim/math/pose.h"
#include "sim/physics/body_spec.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// Whether a panorama taken at `goal` belongs to the node of one taken at `source`: it is at most
/// 3 m away and some ray within 2.5 degrees of its direction runs free at camera height for as far
/// as it is. Source: the connection label of Neural Topological SLAM, appendix B.
bool IsInNode(const sim::World& world, const sim::BodySpec& body, const sim::BodyPose& source,
              const sim::BodyPose& goal);

}  // namespace bulletnav::bench
