// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agent/observation.h"
#include "benchmark/episodes/generator.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/play/condition.h"
#include "benchmark/privileged/mixed_semantic_model.h"
#include "sim/noise/noise_model.h"
#include "sim/simulator.h"

namespace bulletnav::bench {

/// How a file of episodes is drawn if it is not there; see GeneratorSpec.
struct DrawSpec {
  std::vector<std::string> scenes;
  std::optional<HouseSelection> houses;
  EpisodeCounts counts;
  int sequential_goals = 10;
  std::uint64_t seed = 0;

  template <class V>
  void Visit(V& v) {
    v("scenes", scenes);
    v("houses", houses);
    v.Required("counts", counts);
    v("sequential_goals", sequential_goals);
    v("seed", seed);
  }
};

struct EpisodeSource {
  std::string file;
  std::optional<DrawSpec> draw;
  std::vector<std::string> scene_folders;  // where the scenes that episodes name are looked for
  /// True: episodes whose start or goal no body can stand at here are left out, with a warning;
  /// for sets that others drew, with another physics.
  std::optional<bool> skip_unplayable;

  template <class V>
  void Visit(V& v) {
    v.Required("file", file);
    v("draw", draw);
    v("scene_folders", scene_folders);
    v("skip_unplayable", skip_unplayable);
  }
};

/// What a slot of an agent may be filled with besides a file of weights: nothing, the ground truth,
/// or the weights that RunConfig::weights names for it.
inline constexpr const char* kNoModel = "none";
inline constexpr const char* kOracleModel = "oracle";
inline constexpr const char* kLearnedModel = "learned";

/// One agent with its parameters.
struct AgentEntry {
  std::string agent;                  // as it is registered
  std::string name;                   // of its rows and results; the agent's if empty
  std::string title;                  // for people; the paper's if empty
  std::vector<std::string> settings;  // the run's if empty
  /// What fills the agent's slots, see agent::ModelSlot: `learned` where nothing is said.
  std::map<std::string, std::string> models;
  std::vector<SemanticFunction> oracle_functions;  // of a learned model, to look for causes
  int lanes = 1;                            // episodes that one worker runs through it at once
  std::optional<sim::YamlNode> parameters;  // the agent's own config
  std::string trouble;                      // see LoadSavedRunConfig; in no file

  template <class V>
  void Visit(V& v) {
    v.Required("agent", agent);
    v("name", name);
    v("title", title);
    v("settings", settings);
    v("models", models);
    v("oracle_functions", oracle_functions);
    v("lanes", lanes);
    v("parameters", parameters);
  }
  void Validate() const;
};

/// What results were made from, as hashes of contents.
struct Fingerprints {
  std::string episodes;
  std::map<std::string, std::string> scenes;
  std::map<std::string, std::string> weights;  // by key of `weights`, or file; of those in use
  /// By name of the agent, of code that is not the program's; see agent::ForeignAgent.
  std::optional<std::map<std::string, std::string>> sources = std::nullopt;

  template <class V>
  void Visit(V& v) {
    v("episodes", episodes);
    v("scenes", scenes);
    v("weights", weights);
    v("sources", sources);
  }
  bool operator==(const Fingerprints&) const = default;
};

/// An experiment: every agent under every condition and seed, over the same episodes.
struct RunConfig {
  std::string name;  // of the folder of results; the config file's if empty
  std::optional<HousesSpec> houses;
  EpisodeSource episodes;
  ImportSpec import;
  sim::NavmeshSpec navmesh;
  sim::BodySpec body;
  sim::PanoramaSpec panorama;
  sim::Backend backend = sim::Backend::kAuto;
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;  // where the condition has noise
  std::optional<std::string> sensor_noise;  // of cameras, see sim::NamedSensorNoise; default: none
  std::map<std::string, sim::SensorSet> sensors;  // more settings, by name; see SensorsOf
  /// What goals are pictures of, where they are no panoramas; see Task::goal_camera. Settings are
  /// then those of `sensors`, without a panorama.
  std::optional<sim::PinholeSpec> goal;
  std::vector<std::string> settings = {"rgbd"};
  std::vector<Condition> conditions = {Condition::kNoise};
  std::vector<std::uint64_t> seeds = {0};
  double success_distance = 1.0;  // metres
  int max_steps = 500;            // a goal
  /// Files of learned models by SLOT'S WEIGHTS_SETTING, as nts_rgbd, or without a setting for all
  /// that have none of their own. Those that are not named are in assets/weights. One of `sensors`
  /// without weights takes those of rgb or rgbd.
  std::map<std::string, std::string> weights;
  bool trajectories = true;     // kept for plots
  std::optional<bool> beliefs;  // of each step, kept for replays; never saved: see RunBenchmark
  std::vector<AgentEntry> agents;
  std::optional<Fingerprints> fingerprints;  // in saved configs: checked

  template <class V>
  void Visit(V& v) {
    v("name", name);
    v("houses", houses);
    v.Required("episodes", episodes);
    v("import", import);
    v("navmesh", navmesh);
    v("body", body);
    v("panorama", panorama);
    v("backend", backend);
    v("noise", noise);
    v("sensor_noise", sensor_noise);
    v("sensors", sensors);
    v("goal", goal);
    v("settings", settings);
    v("conditions", conditions);
    v("seeds", seeds);
    v("success_distance", success_distance);
    v("max_steps", max_steps);
    v("weights", weights);
    v("trajectories", trajectories);
    v("beliefs", beliefs);
    v.Required("agents", agents);
    v("fingerprints", fingerprints);
  }
  void Validate() const;

  /// How its scenes are loaded.
  sim::WorldOptions world_options() const { return {import.options(), navmesh, backend}; }
  std::string weights_file(const std::string& key) const;
  /// What draws the episodes, where `episodes.draw` is given.
  GeneratorSpec generator() const;
};

/// What bodies sense in a setting: `rgb` (a panorama as `panorama` says, odometry, bumper), `rgbd`
/// (with depth), or one of `sensors`.
sim::SensorSet SensorsOf(const RunConfig& config, const std::string& setting);

/// How agents are told, among the arrays of their rig, what goals are where they are no panoramas.
inline constexpr const char* kGoalPicture = "goal.color";

/// What an agent is told of the body that it steers in a setting.
agent::Rig RigOf(const RunConfig& config, const std::string& setting);

/// Agents that the tables have rows for although the program may not have them yet.
bool IsPlannedAgent(const std::string& agent);

/// Reads a config, fills in names and every default of the agents' parameters. Throws
/// sim::FileError at file:line:column: unknown keys and agents with the nearest known one, values
/// that make no sense, two rows of one name. Agents that IsPlannedAgent alone knows pass.
/// `overrides`: see sim::WithOverrides.
RunConfig LoadRunConfig(const std::filesystem::path& file,
                        std::span<const std::string> overrides = {});
RunConfig ParseRunConfig(const std::string& text, const std::filesystem::path& file);
/// The same for the config.yaml of results, to show them: agents that this version does not know,
/// or not with these parameters, pass, and have a `trouble`.
RunConfig LoadSavedRunConfig(const std::filesystem::path& file);

}  // namespace bulletnav::bench
