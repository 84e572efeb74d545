// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/observation.h"
#include "sim/math/pose.h"
#include "sim/physics/body_spec.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// What no agent may see: whoever takes one of these is privileged, and its rows say so. Whoever
/// runs the episode keeps it true.
struct GroundTruth {
  std::shared_ptr<const sim::World> world;
  sim::BodySpec body;
  sim::BodyPose pose;  // of the body, now
  sim::BodyPose goal;
  agent::Panorama goal_panorama = {};  // taken there, to tell it from what the body sees
};

}  // namespace bulletnav::bench
