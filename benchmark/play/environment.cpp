// SPDX-License-Identifier: MIT
#include "benchmark/play/environment.h"

#include <utility>

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

sim::SimulatorSpec SimulatorSpecOf(const Task& task) {
  return {task.body,  task.panorama, task.noise,       task.color,
          task.depth, task.sensors,  task.sensor_noise};
}

}  // namespace

Environment::Environment(const Task& task, std::vector<GroundTruth*> truths, int threads)
    : task_(task), threads_(threads), lanes_(truths.size()), worlds_(truths.size()) {
  for (std::size_t i = 0; i < truths.size(); ++i) lanes_[i].truth = truths[i];
  const std::size_t pixels = lanes_.size() * task.panorama.pixels();
  if (task.color) color_.resize(3 * pixels);
  if (task.depth) depth_.resize(pixels);
  if (!task.sensor_noise.is_none()) {
    goal_noise_.emplace(task.sensor_noise, task.goal_camera ? sim::CameraSpec(*task.goal_camera)
                                                            : sim::CameraSpec(task.panorama));
  }
  MakeMemory();
}

Environment::~Environment() = default;

Environment::Lane& Environment::at(int lane) {
  return lanes_.at(static_cast<std::size_t>(lane));
}

const Environment::Lane& Environment::at(int lane) const {
  return lanes_.at(static_cast<std::size_t>(lane));
}

const TaskEpisode& Environment::episode(int lane) const {
  const Lane& own = at(lane);
  if (!own.episode) throw sim::Error(fmt::format("lane {} has no episode; Reset it first", lane));
  return *own.episode;
}

void Environment::MakeMemory() {
  arrays_ = SimulatorSpecOf(task_).AllSensors().arrays();
  const std::size_t lanes = lanes_.size();
  bytes_.reserve(arrays_.size());
  for (const sim::ArraySpec& array : arrays_) {
    if (array.name == sim::Observation::kColor) {
      memory_.push_back(std::as_writable_bytes(std::span(color_)));
    } else if (array.name == sim::Observation::kDepth) {
      memory_.push_back(std::as_writable_bytes(std::span(depth_)));
    } else {
      memory_.emplace_back(bytes_.emplace_back(lanes * array.bytes()));
      others_.push_back({array.name, memory_.back()});
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      lanes_[lane].arrays.emplace_back(array,
                                       memory_.back().subspan(lane * array.bytes(), array.bytes()));
    }
  }
}

void Environment::Enter(int lane, const std::shared_ptr<const sim::World>& world) {
  if (!simulator_) {
    worlds_.assign(worlds_.size(), world);
    simulator_ = std::make_unique<sim::BatchSimulator>(worlds_, SimulatorSpecOf(task_), threads_);
  }
  std::shared_ptr<const sim::World>& own = worlds_[static_cast<std::size_t>(lane)];
  if (own == world) return;
  simulator_->SetWorld(lane, world);
  own = world;
  at(lane).goal_camera.reset();
}

void Environment::Reset(int lane, EpisodeTask episode, std::shared_ptr<const sim::World> world) {
  Clear(lane);
  const std::string name =
      fmt::format("episode '{}' in {}", episode.episode.id, episode.episode.scene);
  const sim::BodyPose start = episode.episode.start();
  Enter(lane, world);
  Lane& own = at(lane);
  own.sensors = {};
  try {
    own.episode.emplace(std::move(episode), task_, std::move(world));
    simulator_->Reset(lane, start, own.episode->random_key());
    StartGoals(lane);
  } catch (const sim::Error& e) {
    Clear(lane);
    throw sim::Error(name + ": " + e.what());
  }
}

void Environment::Clear(int lane) {
  at(lane).episode.reset();
}

/// Begins the present goal; one that the body is at already is followed by the next.
void Environment::StartGoals(int lane) {
  Lane& own = at(lane);
  while (!own.episode->is_over()) {
    const sim::BodyPose here = simulator_->body(lane).true_pose();
    own.episode->StartGoal(here);
    *own.truth = {worlds_[static_cast<std::size_t>(lane)], task_.body, here,
                  own.episode->goal_pose()};
    own.has_new_goal = true;
    DrawGoal(lane);
    own.truth->goal_panorama = goal(lane);
    if (!own.episode->IsThere()) return;
    own.episode->EndGoal(false);
  }
}

void Environment::DrawGoal(int lane) {
  if (!draws()) return;
  Lane& own = at(lane);
  const sim::BodyPose pose = own.episode->goal_pose();
  const Eigen::Vector3d position = pose.position + Eigen::Vector3d(0, task_.body.camera_height, 0);
  const sim::CameraPose eye = {position.cast<float>(), static_cast<float>(pose.yaw)};
  std::vector<std::uint8_t> glass;
  if (task_.goal_camera) {
    DrawGoalPicture(&own, eye);
  } else {
    if (task_.color) own.goal_color.resize(3 * task_.panorama.pixels());
    if (task_.depth) own.goal_depth.resize(task_.panorama.pixels());
    const bool asks_for_glass = task_.depth && goal_noise_ && goal_noise_->asks_for_glass();
    if (asks_for_glass && own.episode->world().render_scene().has_glass()) {
      glass.resize(own.goal_depth.size());
    }
    simulator_->Render(lane, eye, {own.goal_color, own.goal_depth}, glass);
  }
  if (goal_noise_) goal_noise_->Apply(GoalNoise(lane), own.goal_color, own.goal_depth, glass);
}

/// Other numbers for each goal of each episode.
sim::Rng Environment::GoalNoise(int lane) const {
  const TaskEpisode& own = episode(lane);
  const sim::EpisodeKey& key = own.random_key();
  return sim::Rng({key.run_seed, own.world().id(), key.episode, 0, sim::Stream::kSensors})
      .Fork("goal", own.goal());
}

void Environment::DrawGoalPicture(Lane* lane, const sim::CameraPose& eye) {
  if (!lane->goal_camera) {
    lane->goal_camera = lane->episode->world().render_scene().MakeRenderer(*task_.goal_camera);
  }
  lane->goal_color.resize(3 * task_.goal_camera->pixels());
  lane->goal_camera->Render({&eye, 1}, lane->goal_color, {});
}

bool Environment::TakeNewGoal(int lane) {
  return std::exchange(at(lane).has_new_goal, false);
}

agent::Panorama Environment::goal(int lane) const {
  return {at(lane).goal_color, at(lane).goal_depth};
}

void Environment::Observe(std::span<const int> lanes) {
  for (const int lane : lanes) BULLETNAV_CHECK(has_episode(lane));
  simulator_->Observe(lanes, {color_, depth_, others_});
}

agent::Observation Environment::observation(int lane) const {
  const auto pixels = static_cast<std::size_t>(lane) * task_.panorama.pixels();
  agent::Observation seen;
  if (task_.color) {
    seen.panorama.color = std::span(color_).subspan(3 * pixels, 3 * task_.panorama.pixels());
  }
  if (task_.depth) seen.panorama.depth = std::span(depth_).subspan(pixels, task_.panorama.pixels());
  seen.odometry = at(lane).sensors.odometry;
  seen.collided = at(lane).sensors.collided;
  seen.step = simulator_->body(lane).steps();
  seen.arrays = at(lane).arrays;
  return seen;
}

std::span<const StepOutcome> Environment::Step(std::span<const int> lanes,
                                               std::span<const sim::Action> actions) {
  return Advance(lanes, actions, {});
}

std::span<const StepOutcome> Environment::StepAndObserve(std::span<const int> lanes,
                                                         std::span<const sim::Action> actions) {
  return Advance(lanes, actions, {color_, depth_, others_});
}

/// Moves bodies, keeps accounts, and reads the sensors that are asked for. Accounts look for ways
/// on the navmesh where a reward asks for distances, so each is kept by the thread of its lane.
std::span<const StepOutcome> Environment::Advance(std::span<const int> lanes,
                                                  std::span<const sim::Action> actions,
                                                  const sim::BatchObservations& seen) {
  for (const int lane : lanes) BULLETNAV_CHECK(!is_over(lane));
  read_.resize(lanes.size());
  outcomes_.assign(lanes.size(), {});
  const auto keep_account = [&](std::size_t i, const sim::Sensors& sensors) {
    Lane& own = at(lanes[i]);
    own.sensors = sensors;
    own.truth->pose = simulator_->body(lanes[i]).true_pose();
    outcomes_[i] = own.episode->Take(actions[i], own.truth->pose, sensors);
  };
  simulator_->Step(lanes, actions, read_, seen, keep_account);
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (!outcomes_[i].terminated && !outcomes_[i].truncated) continue;
    try {
      StartGoals(lanes[i]);
    } catch (const sim::Error& e) {
      Fail(lanes[i], e.what());
    }
  }
  return outcomes_;
}

void Environment::Fail(int lane, const std::string& why) {
  episode(lane);
  at(lane).episode->Fail(why, simulator_->body(lane).true_pose());
}

}  // namespace bulletnav::bench
