// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/observation.h"
#include "benchmark/episodes/episode.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/play/metrics.h"
#include "benchmark/play/trajectory.h"
#include "sim/simulated_body.h"

namespace bulletnav::bench {

/// How episodes of one row of a run are played.
struct EpisodeRules {
  sim::BodySpec body;
  sim::PanoramaSpec panorama;
  bool color = true;  // of the panoramas; nothing is drawn if neither is wanted
  bool depth = true;
  sim::NoiseMode noise = sim::NoiseMode::kNone;
  SuccessRule success;
  int max_steps = 500;  // a goal
};

struct EpisodeTask {
  ResultKey key;
  Episode episode;
  std::filesystem::path scene_file;
};

/// One episode being played: the body, what it sees, and the account of how it does. Whoever plays
/// it asks for the next observation, hands back an action, and so on until it is over:
///   while (!run.is_over()) {
///     if (run.has_new_goal()) { /* tell the agent */ }
///     run.Apply(/* what the agent makes of */ run.Look());
///   }
/// Goals of a sequence come one after the other, each from where the last one ended, reached or
/// not, with steps of its own. Source: Neural Topological SLAM, sections 5 and 6.1.
class EpisodeRun {
 public:
  /// Keeps `truth` true, which must outlive the run. Throws sim::Error, naming the episode, if it
  /// cannot be played.
  EpisodeRun(EpisodeTask task, const EpisodeRules& rules, std::shared_ptr<const sim::World> world,
             GroundTruth* truth);

  bool is_over() const { return goal_ >= task_.episode.goals.size(); }
  /// Whether the goal has changed since this was last asked.
  bool TakeNewGoal();
  bool is_first_goal() const { return goal_ == 0; }
  /// The panorama of the present goal; lives until the goal changes.
  agent::Panorama goal() const { return {goal_color_, goal_depth_}; }
  /// For the agent's random choices on the way to the present goal.
  std::uint64_t agent_seed() const;

  /// What the body senses now; lives until the next call.
  agent::Observation Look();
  void Apply(sim::Action action);

  /// Takes the agent off: the present goal and those after it are not reached.
  void Fail(const std::string& why);

  /// Expects: over (checked). `belief`: the agent's at the end.
  EpisodeTrajectory Finish(agent::Belief belief) const;

 private:
  void StartGoal();
  void EndGoal(bool stopped);
  void Draw(const sim::CameraPose& camera, std::vector<std::uint8_t>* color,
            std::vector<float>* depth);
  std::vector<Eigen::Vector3d> ShortestPath() const;

  EpisodeTask task_;
  EpisodeRules rules_;
  std::shared_ptr<const sim::World> world_;
  GroundTruth* truth_;
  sim::NavmeshQuery query_;
  sim::SimulatedBody body_;
  std::unique_ptr<sim::PanoramaRenderer> renderer_;  // null if nothing is drawn
  std::optional<GoalWatch> watch_;
  std::size_t goal_ = 0;
  int goal_steps_ = 0;  // actions on the way to it
  bool has_new_goal_ = false;
  std::vector<std::uint8_t> goal_color_;
  std::vector<float> goal_depth_;
  std::vector<std::uint8_t> color_;
  std::vector<float> depth_;
  sim::Sensors sensors_;
  sim::EpisodeKey random_key_;
  sim::PlanarPose believed_;
  std::vector<TrajectoryStep> steps_;
  std::vector<GoalMetrics> metrics_;
  std::string failure_;
};

}  // namespace bulletnav::bench
