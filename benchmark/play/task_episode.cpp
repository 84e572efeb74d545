// SPDX-License-Identifier: MIT
#include "benchmark/play/task_episode.h"

#include <cmath>

#include "sim/base/check.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
TaskEpisode::TaskEpisode(EpisodeTask episode, const Task& task,
                         std::shared_ptr<const sim::World> world)
    : episode_(std::move(episode)),
      task_(task),
      world_(std::move(world)),
      query_(world_->navmesh()),
      random_key_{episode_.key.seed, sim::Hash64(episode_.episode.id)} {}

std::uint64_t TaskEpisode::agent_seed() const {
  const std::uint64_t episode = sim::MixSeed(random_key_.run_seed, world_->id());
  return sim::MixSeed(sim::MixSeed(episode, random_key_.episode), goal_);
}

void TaskEpisode::StartGoal(const sim::BodyPose& here) {
  watch_.emplace(query_, here.position, goal_pose().position, task_.success);
  goal_steps_ = 0;
  if (task_.reward) distance_left_ = watch_->Geodesic();
}

bool TaskEpisode::IsThere() const {
  return task_.success.no_stop && watch_->Reached();
}

StepOutcome TaskEpisode::Take(sim::Action action, const sim::BodyPose& now,
                              const sim::Sensors& sensors) {
  BULLETNAV_CHECK(!is_over());
  believed_ = Compose(believed_, sensors.odometry);
  steps_.push_back({action, now, believed_, sensors.collided});
  ++goal_steps_;
  StepOutcome outcome;
  const bool stops = action == sim::Action::kStop && !task_.success.no_stop;
  if (!stops) watch_->Step(now.position, sensors.collided);
  outcome.terminated = stops || IsThere();
  outcome.truncated = !outcome.terminated && goal_steps_ >= task_.max_steps;
  const double left = distance_left_;
  if (task_.reward) {
    // From where no way leads to the goal, as from between two pieces of furniture, none is left:
    // what was gained or lost there counts when there is one again.
    const double here = watch_->Geodesic();
    if (std::isfinite(here)) distance_left_ = here;
  }
  if (outcome.terminated || outcome.truncated) EndGoal(stops);
  if (task_.reward) {
    outcome.reward = task_.reward->step + task_.reward->progress * (left - distance_left_);
    if (outcome.terminated) outcome.reward += task_.reward->success * metrics_.back().Value("spl");
  }
  return outcome;
}

void TaskEpisode::EndGoal(bool stopped) {
  metrics_.push_back(watch_->Finish(stopped));
  ++goal_;
}

void TaskEpisode::Fail(const std::string& why, const sim::BodyPose& here) {
  failure_ = why;
  const auto& goals = episode_.episode.goals;
  Eigen::Vector3d from = here.position;
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

std::vector<Eigen::Vector3d> TaskEpisode::ShortestPath() const {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d from = episode_.episode.start_position;
  for (const EpisodeGoal& goal : episode_.episode.goals) {
    const auto path = query_.FindPath(from.cast<float>(), goal.position.cast<float>());
    from = goal.position;
    if (!path) continue;
    for (const Eigen::Vector3f& point : path->points) points.push_back(point.cast<double>());
  }
  return points;
}

EpisodeTrajectory TaskEpisode::Finish(agent::Belief belief) const {
  BULLETNAV_CHECK(is_over());
  EpisodeTrajectory trajectory;
  trajectory.result = {episode_.key, episode_.episode.difficulty, metrics_, failure_};
  trajectory.scene_file = episode_.scene_file;
  trajectory.key = random_key_;
  trajectory.noise = task_.noise;
  trajectory.body = task_.body;
  trajectory.start = episode_.episode.start();
  for (std::size_t i = 0; i < episode_.episode.goals.size(); ++i) {
    trajectory.goals.push_back(episode_.episode.goal(i));
  }
  trajectory.steps = steps_;
  trajectory.shortest_path = ShortestPath();
  trajectory.belief = std::move(belief);
  return trajectory;
}

}  // namespace bulletnav::bench
