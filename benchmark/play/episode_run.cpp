// SPDX-License-Identifier: MIT
#include "benchmark/play/episode_run.h"

#include <algorithm>

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {

EpisodeRun::EpisodeRun(EpisodeTask task, const EpisodeRules& rules,
                       std::shared_ptr<const sim::World> world, GroundTruth* truth)
    : task_(std::move(task)),
      rules_(rules),
      world_(std::move(world)),
      truth_(truth),
      query_(world_->navmesh()),
      body_(world_, rules.body, sim::NoiseModel(rules.noise)),
      random_key_{task_.key.seed, sim::Hash64(task_.episode.id)} {
  if (rules.color || rules.depth) renderer_ = world_->render_scene().MakeRenderer(rules.panorama);
  try {
    body_.Reset(task_.episode.start(), random_key_);
    StartGoal();
  } catch (const sim::Error& e) {
    throw sim::Error(
        fmt::format("episode '{}' in {}: {}", task_.episode.id, task_.episode.scene, e.what()));
  }
}

bool EpisodeRun::TakeNewGoal() {
  return std::exchange(has_new_goal_, false);
}

std::uint64_t EpisodeRun::agent_seed() const {
  const std::uint64_t episode = sim::MixSeed(random_key_.run_seed, world_->id());
  return sim::MixSeed(sim::MixSeed(episode, random_key_.episode), goal_);
}

void EpisodeRun::StartGoal() {
  const sim::BodyPose goal = task_.episode.goal(goal_);
  watch_.emplace(query_, body_.true_pose().position, goal.position, rules_.success);
  *truth_ = {world_, rules_.body, body_.true_pose(), goal};
  goal_steps_ = 0;
  has_new_goal_ = true;
  const Eigen::Vector3d eye = goal.position + Eigen::Vector3d(0, rules_.body.camera_height, 0);
  Draw({eye.cast<float>(), static_cast<float>(goal.yaw)}, &goal_color_, &goal_depth_);
  truth_->goal_panorama = this->goal();
  if (rules_.success.no_stop && watch_->Reached()) EndGoal(false);
}

void EpisodeRun::EndGoal(bool stopped) {
  metrics_.push_back(watch_->Finish(stopped));
  ++goal_;
  if (is_over()) return;
  try {
    StartGoal();
  } catch (const sim::Error& e) {
    Fail(e.what());
  }
}

void EpisodeRun::Draw(const sim::CameraPose& camera, std::vector<std::uint8_t>* color,
                      std::vector<float>* depth) {
  if (!renderer_) return;
  if (rules_.color) color->resize(3 * rules_.panorama.pixels());
  if (rules_.depth) depth->resize(rules_.panorama.pixels());
  renderer_->Render({&camera, 1}, *color, *depth);
}

agent::Observation EpisodeRun::Look() {
  CHECK(!is_over());
  Draw(body_.camera_pose(), &color_, &depth_);
  return {{color_, depth_}, sensors_.odometry, sensors_.collided, body_.steps()};
}

void EpisodeRun::Apply(sim::Action action) {
  CHECK(!is_over());
  sensors_ = body_.Step(action);
  truth_->pose = body_.true_pose();
  believed_ = Compose(believed_, sensors_.odometry);
  steps_.push_back({action, body_.true_pose(), believed_, sensors_.collided});
  ++goal_steps_;
  if (action == sim::Action::kStop && !rules_.success.no_stop) {
    EndGoal(true);
    return;
  }
  watch_->Step(body_.true_pose().position, sensors_.collided);
  const bool is_reached = rules_.success.no_stop && watch_->Reached();
  if (is_reached || goal_steps_ >= rules_.max_steps) EndGoal(false);
}

void EpisodeRun::Fail(const std::string& why) {
  failure_ = why;
  const auto& goals = task_.episode.goals;
  Eigen::Vector3d from = body_.true_pose().position;
  if (!is_over() && watch_ && goal_steps_ > 0) {
    metrics_.push_back(watch_->Fail());
    from = goals[goal_].position;
    ++goal_;
  }
  for (; !is_over(); ++goal_) {
    const EpisodeGoal& goal = goals[goal_];
    metrics_.push_back(UntriedGoal(query_, from, goal.position, goal.geodesic_distance));
    from = goal.position;
  }
}

std::vector<Eigen::Vector3d> EpisodeRun::ShortestPath() const {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d from = task_.episode.start_position;
  for (const EpisodeGoal& goal : task_.episode.goals) {
    const auto path = query_.FindPath(from.cast<float>(), goal.position.cast<float>());
    from = goal.position;
    if (!path) continue;
    for (const Eigen::Vector3f& point : path->points) points.push_back(point.cast<double>());
  }
  return points;
}

EpisodeTrajectory EpisodeRun::Finish(agent::Belief belief) const {
  CHECK(is_over());
  EpisodeTrajectory trajectory;
  trajectory.result = {task_.key, task_.episode.difficulty, metrics_, failure_};
  trajectory.scene_file = task_.scene_file;
  trajectory.key = random_key_;
  trajectory.noise = rules_.noise;
  trajectory.body = rules_.body;
  trajectory.start = task_.episode.start();
  for (std::size_t i = 0; i < task_.episode.goals.size(); ++i) {
    trajectory.goals.push_back(task_.episode.goal(i));
  }
  trajectory.steps = steps_;
  trajectory.shortest_path = ShortestPath();
  trajectory.belief = std::move(belief);
  return trajectory;
}

}  // namespace bulletnav::bench
