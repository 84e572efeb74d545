// SPDX-License-Identifier: MIT
#include "sim/simulated_body.h"

#include <algorithm>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {
namespace {

const World& Checked(const std::shared_ptr<const World>& world) {
  internal::RequireWorld(world, "SimulatedBody");
  return *world;
}

void RequirePlaced(bool is_placed, const char* call) {
  if (!is_placed)
    throw Error(std::string(call) + ": the body stands nowhere yet; call Reset first");
}

}  // namespace

void internal::RequireWorld(const std::shared_ptr<const World>& world, const char* call) {
  if (!world) throw Error(std::string(call) + ": the world is null; load one with World::Load");
}

void internal::RequireAction(Action action, const char* call) {
  if (std::find(kAllActions.begin(), kAllActions.end(), action) == kAllActions.end()) {
    throw Error(fmt::format("{}: {} is no action", call, static_cast<int>(action)));
  }
}

SimulatedBody::SimulatedBody(std::shared_ptr<const World> world, const BodySpec& spec,
                             const NoiseModel& noise)
    : world_(std::move(world)), noise_(noise), body_(Checked(world_).physics(), spec) {}

void SimulatedBody::Reset(const BodyPose& pose, const EpisodeKey& key) {
  body_.Reset(pose);
  is_placed_ = true;
  key_ = key;
  steps_ = 0;
  collisions_ = 0;
  path_length_ = 0.0;
}

Sensors SimulatedBody::Step(Action action) {
  RequirePlaced(is_placed_, "SimulatedBody::Step");
  internal::RequireAction(action, "SimulatedBody::Step");
  const auto rng = [&](Stream stream) {
    return Rng(RngKey{key_.run_seed, world_->id(), key_.episode, static_cast<std::uint32_t>(steps_),
                      stream});
  };
  Rng actuation = rng(Stream::kActuation);
  Rng odometry = rng(Stream::kOdometry);
  const BodyPose before = body_.pose();
  const MoveResult move = body_.Move(noise_.Actuation(action, actuation));
  const BodyPose& after = body_.pose();
  ++steps_;
  collisions_ += move.collided ? 1 : 0;
  path_length_ += (after.position - before.position).norm();
  return {noise_.Odometry(action, RelativePose(before, after), odometry), move.collided};
}

CameraPose SimulatedBody::camera_pose() const {
  RequirePlaced(is_placed_, "SimulatedBody::camera_pose");
  const BodyPose& pose = body_.pose();
  const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0, body_.spec().camera_height, 0);
  return {eye.cast<float>(), static_cast<float>(pose.yaw)};
}

}  // namespace bulletnav::sim
