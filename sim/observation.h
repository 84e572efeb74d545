// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/math/pose.h"

namespace bulletnav::sim {

/// What the body's sensors, other than its camera, read after a step.
struct Sensors {
  PlanarPose odometry;    // measured change of pose in this step, in the frame before it
  bool collided = false;  // the bumper: something was in the way
};

/// What the body senses after a reset or a step. Panorama: see Renderer.
struct Observation {
  std::vector<std::uint8_t> color;  // [rows, cols, 3], empty if the spec wants none
  std::vector<float> depth;         // [rows, cols] metres, likewise
  Sensors sensors;
};

}  // namespace bulletnav::sim
