// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/episodes/generator.h"
#include "benchmark/play/vector_environment.h"
#include "sim/config/yaml_reader.h"

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Autoreset> {
  static constexpr std::array kNames = {
      std::pair{"next_step", bulletnav::bench::Autoreset::kNextStep},
      std::pair{"same_step", bulletnav::bench::Autoreset::kSameStep},
      std::pair{"disabled", bulletnav::bench::Autoreset::kNever}};
};

namespace bulletnav::python {

/// The keyword arguments of bulletnav.VectorEnv: what is played, with what body, and how.
struct LanesConfig {
  std::vector<std::string> scenes;             // mesh files to draw episodes in
  std::string episodes;                        // or a file of episodes
  std::vector<std::string> scene_folders;      // where its scenes are looked for
  std::optional<bench::EpisodeCounts> counts;  // to draw; absent: 20 easy ones a scene
  int sequential_goals = 10;
  std::uint64_t episode_seed = 0;  // of the draw

  int num_envs = 1;
  int threads = 0;  // < 1: one per processor
  std::uint64_t seed = 0;
  bool shuffle = false;
  bench::Autoreset autoreset_mode = bench::Autoreset::kNextStep;

  sim::SensorSet sensors = sim::SensorSet::Named("rgbd");
  sim::BodySpec body;
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  std::string sensor_noise = "none";  // see sim::NamedSensorNoise
  double success_distance = 1.0;      // metres
  bool no_stop = false;               // near is enough
  int max_steps = 500;                // a goal
  bench::RewardSpec reward;

  bench::ImportSpec scene_import;
  sim::NavmeshSpec navmesh;
  sim::Backend backend = sim::Backend::kAuto;

  template <class V>
  void Visit(V& v) {
    v("scenes", scenes);
    v("episodes", episodes);
    v("scene_folders", scene_folders);
    v("counts", counts);
    v("sequential_goals", sequential_goals);
    v("episode_seed", episode_seed);
    v("num_envs", num_envs);
    v("threads", threads);
    v("seed", seed);
    v("shuffle", shuffle);
    v("autoreset_mode", autoreset_mode);
    v("sensors", sensors);
    v("body", body);
    v("noise", noise);
    v("sensor_noise", sensor_noise);
    v("success_distance", success_distance);
    v("no_stop", no_stop);
    v("max_steps", max_steps);
    v("reward", reward);
    v("import", scene_import);
    v("navmesh", navmesh);
    v("backend", backend);
  }
  /// Throws sim::Error for what makes no sense together.
  void Validate() const;

  sim::WorldOptions world_options() const { return {scene_import.options(), navmesh, backend}; }
  bench::Task task() const;
};

}  // namespace bulletnav::python
