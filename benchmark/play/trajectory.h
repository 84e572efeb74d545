// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "agent/belief.h"
#include "benchmark/play/episode_result.h"
#include "sim/base/action.h"
#include "sim/math/pose.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/body_spec.h"
#include "sim/simulated_body.h"

namespace bulletnav::bench {

/// One action and what came of it.
struct TrajectoryStep {
  sim::Action action = sim::Action::kStop;
  sim::BodyPose pose;        // true, after the action
  sim::PlanarPose odometry;  // believed, after it: readings added up, seen from the start pose
  bool collided = false;
};

/// All that is needed to draw an episode, and to live through it again.
struct EpisodeTrajectory {
  EpisodeResult result;              // which one, and how it ended
  std::filesystem::path scene_file;  // that sim::World::Load can read
  sim::EpisodeKey key;
  sim::NoiseMode noise = sim::NoiseMode::kNone;
  sim::BodySpec body;
  sim::BodyPose start;                         // as given to sim::Simulator::Reset
  std::vector<sim::BodyPose> goals;            // in order; their yaw is that of the goal's panorama
  std::vector<TrajectoryStep> steps;           // every action, stops too
  std::vector<Eigen::Vector3d> shortest_path;  // from the start to each goal in turn
  agent::Belief belief;                        // at the end; may be empty
};

/// Where a run keeps the trajectory of one of its results:
/// trajectories/AGENT-SETTING-CONDITION-SEED/SCENE-EPISODE.json below the run's folder, SCENE
/// without folders and extension. Letters that no file's name should have become "_".
std::filesystem::path TrajectoryPath(const std::filesystem::path& run_folder, const ResultKey& key);

/// One JSON object. Keys:
///   result        object: the line of episodes.jsonl
///   scene_file    text
///   run_seed, episode_number   the random key of noise
///   noise         "none", "ans_released", ...; body: object of sim::BodySpec's members
///   start, goals  [x, y, z, yaw], list of them: true poses, metres and radians, all digits
///   shortest_path list of [x, y, z]
///   actions       text, a letter a step: F forward, L left, R right, S stop
///   collided      text, a digit a step: 1 collided, 0 not
///   poses         list of [x, y, z, yaw], one a step: true, after it
///   odometry      list of [x, y, yaw], one a step: believed, after it, from the start pose
///   belief        object of what there is of: pose, target [x, y, yaw];
///                 map {size, cell, low_x, low_y, rows}, rows: a text a row of run lengths and
///                 kinds, "?" unknown, "." free, "#" obstacle, "!" felt wall, as in "12?3.1#";
///                 graph {nodes [[x, y, 1 if ghost, score if any]], edges [[i, j]], path [i]}
/// Metres and radians of paths, poses, odometry and belief are rounded to 1e-6.
std::string ToJson(const EpisodeTrajectory& trajectory);

/// Reads what ToJson wrote. Throws sim::FileError, naming file and place in it.
EpisodeTrajectory ReadTrajectory(const std::filesystem::path& file);

}  // namespace bulletnav::bench
