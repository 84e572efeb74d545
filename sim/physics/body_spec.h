// SPDX-License-Identifier: MIT
#pragma once
#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// An upright capsule that stands on the floor. Metres. Source: ANS/Habitat defaults; LoCoBot's
/// body.
struct BodySpec {
  float radius = 0.10f;
  float height = 1.5f;
  float camera_height = 1.25f;  // of the eye above the feet; may be above the head
  float max_climb = 0.2f;  // steps and thresholds up to this are walked over, deeper drops are not
  float max_slope_deg = 45.0f;  // of the floor
  bool sliding = true;          // along walls; published results depend on it

  static BodySpec Locobot() {
    BodySpec spec;
    spec.radius = 0.18f;
    spec.height = 0.88f;
    spec.camera_height = 0.88f;
    return spec;
  }

  template <class V>
  void Visit(V& v) {
    v("radius", radius);
    v("height", height);
    v("camera_height", camera_height);
    v("max_climb", max_climb);
    v("max_slope_deg", max_slope_deg);
    v("sliding", sliding);
  }
  /// Throws Error unless the capsule, without the climb, still has a body: all lengths positive,
  /// height >= max_climb + 2 radius.
  void Validate() const;
};

}  // namespace bulletnav::sim
