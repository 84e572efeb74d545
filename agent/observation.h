// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/math/pose.h"
#include "sim/observation.h"
#include "sim/render/projection.h"

namespace bulletnav::agent {

/// An RGBD panorama in somebody else's memory, laid out as Rig::panorama says: column 0 looks
/// behind, columns go clockwise, the middle one looks forward.
struct Panorama {
  std::span<const std::uint8_t> color;  // [rows, cols, 3] RGB; empty if the rig has no colour
  std::span<const float> depth;  // [rows, cols] metres along the ray, 0 = no return; or empty
};

/// All that an agent learns in one step. The panorama lives until the next step.
struct Observation {
  Panorama panorama;
  sim::PlanarPose odometry;  // measured motion of the last step, in the frame before it; noisy
  bool collided = false;     // something was in the way of the last step
  int step = 0;              // actions since Reset
};

/// What an agent knows about the body it steers.
struct Rig {
  sim::PanoramaSpec panorama;
  bool has_color = true;
  bool has_depth = true;
  float camera_height = 1.25f;  // metres above the floor
};

/// Shows an agent what a body senses. The result lives as long as `sensed`.
inline Observation View(const sim::Observation& sensed, int step) {
  return {{sensed.color, sensed.depth}, sensed.sensors.odometry, sensed.sensors.collided, step};
}

}  // namespace bulletnav::agent
