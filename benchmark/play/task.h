// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "benchmark/play/metrics.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/body_spec.h"
#include "sim/render/projection.h"
#include "sim/sensors/noise/sensor_noise.h"
#include "sim/sensors/sensor_set.h"

namespace bulletnav::bench {

/// What a step is worth to whoever learns: `success` times SPL when a goal is reached, `progress`
/// for each metre of geodesic distance that it brings the body nearer, and `step`. Where no way
/// leads from the body to the goal, the distance is what it last was. Source: Neural Topological
/// SLAM, section 5.1.
struct RewardSpec {
  double success = 10.0;
  double progress = 1.0;
  double step = -0.001;

  template <class V>
  void Visit(V& v) {
    v("success", success);
    v("progress", progress);
    v("step", step);
  }
};

/// Image-goal navigation: what bodies carry, what they are asked to do and how they are judged. The
/// paper's three conditions are settings of it: `noise` kNone for "no noise", `success.no_stop` for
/// "no stop". Episodes bring the goals, one or several in turn; each has steps of its own.
/// Source: Neural Topological SLAM, sections 5 and 6.1.
struct Task {
  sim::BodySpec body;
  sim::PanoramaSpec panorama;  // of goals (but see goal_camera), and of what bodies see
  bool color = true;           // of the panoramas; nothing is drawn if neither is wanted
  bool depth = true;
  /// What bodies sense. Empty: the panorama as said above, odometry and bumper. Else its sensor
  /// `panorama` must draw what is said above.
  sim::SensorSet sensors = {};
  /// What goals are pictures of, in colour, where they are no panoramas: from the goal's eye in its
  /// heading. Source: habitat-lab's ImageGoalSensor.
  std::optional<sim::PinholeSpec> goal_camera = {};
  sim::NoiseMode noise = sim::NoiseMode::kNone;
  /// Of all cameras' pictures, goals' too: a goal is a picture that such a body has taken.
  sim::SensorNoise sensor_noise = {};
  SuccessRule success;
  int max_steps = 500;               // a goal
  std::optional<RewardSpec> reward;  // absent: nobody learns, and rewards are 0
};

}  // namespace bulletnav::bench
