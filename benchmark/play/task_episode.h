// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"
#include "benchmark/play/task.h"
#include "benchmark/play/trajectory.h"
#include "sim/simulated_body.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// An episode to be played, and where its result goes.
struct EpisodeTask {
  ResultKey key;
  Episode episode;
  std::filesystem::path scene_file;
};

/// What came of one step.
struct StepOutcome {
  double reward = 0.0;      // see RewardSpec
  bool terminated = false;  // the goal was reached or given up by a stop
  bool truncated = false;   // or its steps ran out
};

/// The account of one episode: its goals, how far the body is from them, its steps and what they
/// came to. It sees true poses and moves nothing: see Environment, which does.
/// Goals of a sequence come one after the other, each from where the last one ended, reached or
/// not.
class TaskEpisode {
 public:
  TaskEpisode(EpisodeTask episode, const Task& task, std::shared_ptr<const sim::World> world);

  bool is_over() const { return goal_ >= episode_.episode.goals.size(); }
  std::size_t goal() const { return goal_; }  // number of the present one, from 0
  sim::BodyPose goal_pose() const { return episode_.episode.goal(goal_); }
  const sim::World& world() const { return *world_; }
  /// Of the noise of its steps.
  const sim::EpisodeKey& random_key() const { return random_key_; }
  /// For an agent's random choices on the way to the present goal.
  std::uint64_t agent_seed() const;

  /// The way to the present goal begins here. Throws sim::Error if there is none.
  void StartGoal(const sim::BodyPose& here);
  /// Whether the present goal is over before the first step: "no stop" from near it.
  bool IsThere() const;
  /// Takes note of a step: where the body now is and what its sensors read. A goal that ends is
  /// followed by the next, which StartGoal has to begin.
  StepOutcome Take(sim::Action action, const sim::BodyPose& now, const sim::Sensors& sensors);
  /// Ends the present goal.
  void EndGoal(bool stopped);

  /// Takes the agent off: the present goal and those after it are not reached.
  void Fail(const std::string& why, const sim::BodyPose& here);

  /// Expects: over (checked). `belief`: the agent's at the end.
  EpisodeTrajectory Finish(agent::Belief belief) const;

 private:
  std::vector<Eigen::Vector3d> ShortestPath() const;

  EpisodeTask episode_;
  Task task_;
  std::shared_ptr<const sim::World> world_;
  sim::NavmeshQuery query_;
  std::optional<GoalWatch> watch_;
  std::size_t goal_ = 0;
  int goal_steps_ = 0;          // actions on the way to it
  double distance_left_ = 0.0;  // geodesic metres, where a reward asks for it
  sim::EpisodeKey random_key_;
  sim::PlanarPose believed_;
  std::vector<TrajectoryStep> steps_;
  std::vector<GoalMetrics> metrics_;
  std::string failure_;
};

}  // namespace bulletnav::bench
