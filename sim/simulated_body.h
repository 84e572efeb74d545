// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "sim/base/action.h"
#include "sim/math/pose.h"
#include "sim/noise/noise_model.h"
#include "sim/observation.h"
#include "sim/physics/capsule_body.h"
#include "sim/world.h"

namespace bulletnav::sim {

/// Which random numbers an episode draws, besides the scene: the same key and actions, the same
/// noise. Give each episode another one.
struct EpisodeKey {
  std::uint64_t run_seed = 0;
  std::uint64_t episode = 0;
};

/// A body that acts in a world with actuation noise and reads noisy odometry; no camera.
/// Deterministic: what a step does is a function of the world, the body's spec, the noise, the key
/// and the actions since Reset; not of threads or of other bodies.
/// Source: Neural Topological SLAM, section 5; noise of Active Neural SLAM.
/// Misuse throws Error that names the call.
class SimulatedBody {
 public:
  /// Keeps the world. Throws Error if it is null or the spec is bad.
  SimulatedBody(std::shared_ptr<const World> world, const BodySpec& spec, const NoiseModel& noise);

  /// Puts the body down (see CapsuleBody::Reset) and starts an episode. Throws PoseError and
  /// changes nothing if the body cannot stand there.
  void Reset(const BodyPose& pose, const EpisodeKey& key);

  /// Executes one action with noise; kStop moves nothing. Throws Error before the first Reset.
  Sensors Step(Action action);

  /// Where the camera is now: spec.camera_height above the feet. Throws Error before the first
  /// Reset.
  CameraPose camera_pose() const;

  /// Ground truth, for metrics, drawing and privileged agents only.
  const BodyPose& true_pose() const { return body_.pose(); }
  int steps() const { return steps_; }
  /// Steps since Reset that met an obstacle.
  int collisions() const { return collisions_; }
  /// Metres really moved since Reset: the L of SPL.
  double path_length() const { return path_length_; }
  const World& world() const { return *world_; }
  /// Whether there was a Reset.
  bool is_placed() const { return is_placed_; }

 private:
  std::shared_ptr<const World> world_;
  NoiseModel noise_;
  CapsuleBody body_;
  bool is_placed_ = false;
  EpisodeKey key_;
  int steps_ = 0;
  int collisions_ = 0;
  double path_length_ = 0.0;
};

namespace internal {

/// What callers of a simulator got wrong, as an Error that names the call.
void RequireWorld(const std::shared_ptr<const World>& world, const char* call);
void RequireAction(Action action, const char* call);

}  // namespace internal
}  // namespace bulletnav::sim
