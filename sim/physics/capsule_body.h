// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include <Eigen/Core>

#include "sim/math/pose.h"
#include "sim/physics/body_spec.h"
#include "sim/physics/physics_world.h"

namespace bulletnav::sim {

/// What a move came to.
struct MoveResult {
  bool collided = false;  // something was in the way, also if the body slid on along it
  int contacts = 0;       // surfaces met, one after the other; a ledge counts as one
};

/// One upright body that walks in a scene: swept, never teleported, so no step is too long for a
/// wall. It climbs steps up to max_climb, stops at deeper drops as at a wall, slides if its spec
/// says so. Several bodies share a world and do not meet. Source: SPEC of the body [ANS/HAB]; the
/// step-slide-drop scheme of character controllers, on Bullet's convex sweep, with every accepted
/// position checked exactly.
class CapsuleBody {
 public:
  /// The world must outlive the body. Throws Error on a bad spec.
  CapsuleBody(const PhysicsWorld& world, const BodySpec& spec);

  /// Puts the body at `pose`, lowered or raised onto the floor within 0.5 m and pushed out of walls
  /// it touches by up to a radius. Throws PoseError, and leaves the body where it was, if the place
  /// is inside something, has no floor, or no head room.
  void Reset(const BodyPose& pose);
  /// Reset for places that may not do: where the body stands then, or nothing.
  std::optional<BodyPose> TryReset(const BodyPose& pose);

  /// Moves by a vector in the body's frame (x forward, y left), metres, then turns by its yaw; the
  /// turn is never hindered.
  MoveResult Move(const PlanarPose& motion);

  const BodyPose& pose() const { return pose_; }
  const BodySpec& spec() const { return spec_; }

 private:
  /// The part of the body above the climbable steps, when its foot is at `foot`.
  Capsule Torso(const Eigen::Vector3f& foot) const;
  /// Height of the floor under `foot`, looking from `above` over it to `below` under it.
  std::optional<float> FloorUnder(const Eigen::Vector3f& foot, float above, float below) const;
  Eigen::Vector3f PushOut(const Eigen::Vector3f& foot) const;
  bool IsFree(const Eigen::Vector3f& foot) const;
  /// Follows `motion` from `foot` as far as floor and walls allow; true if it got all the way.
  bool Walk(const Eigen::Vector3f& motion, Eigen::Vector3f* foot) const;

  const PhysicsWorld& world_;
  BodySpec spec_;
  BodyPose pose_;
};

}  // namespace bulletnav::sim
