// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "sim/observation.h"
#include "sim/render/projection.h"
#include "sim/sensors/array.h"

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
  /// All that the sensors wrote, by the names of Rig::arrays, these three too; lives as long.
  std::vector<sim::ArrayView> arrays = {};

  /// Throws sim::Error for a name that is not there.
  const sim::ArrayView& array(std::string_view name) const {
    for (const sim::ArrayView& array : arrays) {
      if (array.spec().name == name) return array;
    }
    throw sim::Error("the body has no sensor that writes '" + std::string(name) + "'");
  }
};

/// What an agent knows about the body it steers.
struct Rig {
  sim::PanoramaSpec panorama;
  bool has_color = true;
  bool has_depth = true;
  float camera_height = 1.25f;  // metres above the floor
  float body_radius = 0.10f;    // metres, of the upright capsule that must not collide
  float body_height = 1.5f;
  std::vector<sim::ArraySpec> arrays = {};  // of all sensors; empty: of the panorama alone

  /// Null if no sensor writes an array of this name.
  const sim::ArraySpec* FindArray(std::string_view name) const {
    for (const sim::ArraySpec& array : arrays) {
      if (array.name == name) return &array;
    }
    return nullptr;
  }
};

/// Shows an agent what a body senses. The result lives as long as `sensed`.
inline Observation View(const sim::Observation& sensed, int step) {
  Observation seen = {
      {sensed.color, sensed.depth}, sensed.sensors.odometry, sensed.sensors.collided, step};
  seen.arrays.reserve(sensed.arrays.size());
  for (const sim::NamedArray& array : sensed.arrays) {
    seen.arrays.push_back(sensed.array(array.spec.name));
  }
  return seen;
}

}  // namespace bulletnav::agent
