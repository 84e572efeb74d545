// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sim/observation.h"
#include "sim/sensors/noise/sensor_noise.h"
#include "sim/sensors/sensor_reader.h"
#include "sim/simulated_body.h"

namespace bulletnav::sim {

/// How bodies of a run are built and what they sense.
struct SimulatorSpec {
  BodySpec body;
  PanoramaSpec panorama;
  NoiseMode noise = NoiseMode::kAnsReleased;  // kNone: exact motion and odometry
  bool color = true;                          // of the panorama
  bool depth = true;
  /// What the body senses. Empty: a sensor `panorama` as said above, odometry and bumper. Else
  /// panorama, color and depth do not matter.
  SensorSet sensors = {};
  /// Of all cameras, another for each camera, episode and step.
  SensorNoise sensor_noise = {};

  /// The sensors there are, also where `sensors` is empty.
  SensorSet AllSensors() const;

  template <class V>
  void Visit(V& v) {
    v("body", body);
    v("panorama", panorama);
    v("noise", noise);
    v("color", color);
    v("depth", depth);
  }
};

/// One body with a camera in a world; many may share the world, in any threads.
///   Simulator simulator(World::Load("house.glb"), {});
///   Observation observation = simulator.Reset(pose);
///   observation = simulator.Step(Action::kMoveForward);
/// What both return is valid until the next of them.
/// Cost of a step: what its cameras draw; physics and noise are some tens of microseconds.
class Simulator {
 public:
  /// Keeps the world. Throws Error if it is null or the spec is bad.
  Simulator(std::shared_ptr<const World> world, const SimulatorSpec& spec);

  /// Starts an episode. Throws PoseError and changes nothing if the body cannot stand there. The
  /// odometry of the first observation is zero.
  const Observation& Reset(const BodyPose& pose, const EpisodeKey& key = {});
  /// Throws Error before the first Reset.
  const Observation& Step(Action action);

  /// Ground truth, for metrics, drawing and privileged agents only.
  const SimulatedBody& body() const { return body_; }
  const SimulatorSpec& spec() const { return spec_; }

 private:
  const Observation& Observe(const Sensors& sensors);
  std::span<std::byte> MemoryOf(NamedArray* array);

  SimulatorSpec spec_;
  SimulatedBody body_;
  SensorReader sensors_;
  Observation observation_;
};

}  // namespace bulletnav::sim
