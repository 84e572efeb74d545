// SPDX-License-Identifier: MIT
// The command that drives. It is in bulletnav-slam.so; see slam.h.
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/scene_options.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/slam/traversal/tum_recorder.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::bench {
namespace {

struct SlamTraverseOptions {
  SceneOptions scene;
  std::filesystem::path out;
  TraversalSpec traversal;
};

/// Empty for a seed. CLI11 would make other numbers of -1 and of what is too large.
std::string SeedTrouble(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc() && last == end) return "";
  return "expected a whole number from 0 to 18446744073709551615, got '" + text + "'";
}

void DriveAndRecord(const SlamTraverseOptions& options) {
  options.traversal.Validate();
  TumRecorder recorder(options.out, options.traversal);
  sim::WorldOptions world;
  world.import = options.scene.import();
  Traverse(sim::World::Load(options.scene.file, world), options.traversal,
           [&](const TraversalFrame& frame) {
             recorder.Add(frame);
           });
  recorder.Finish();
  fmt::print(stderr, "{} frames written to {}\n", options.traversal.actions + 1,
             options.out.string());
}

}  // namespace

void AddSlamTraverseCommand(CLI::App* slam) {
  auto options = std::make_shared<SlamTraverseOptions>();
  options->traversal.camera.rows = 240;
  options->traversal.camera.cols = 320;
  CLI::App* command =
      slam->add_subcommand("traverse", "Drive through a scene and write what is seen as TUM files");
  options->scene.AddTo(command);
  command->add_option("--out", options->out, "Folder for the recording")->required();
  TraversalSpec& traversal = options->traversal;
  command->add_option("--actions", traversal.actions, "Actions, one frame after each")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--seed", traversal.seed, "Of the route and the noise")
      ->check(SeedTrouble)
      ->capture_default_str();
  AddEnumOption(command, "--noise", &traversal.noise, "Of motion and odometry")
      ->default_str("ans_released");
  command
      ->add_option("--sensor-noise", traversal.sensor_noise,
                   "Of pictures (default none); see docs/rendering.md")
      ->check(CLI::IsMember(sim::SensorNoiseNames()));
  command->add_option("--rows", traversal.camera.rows, "Of pictures")->capture_default_str();
  command->add_option("--cols", traversal.camera.cols, "Of pictures")->capture_default_str();
  command->add_option("--hfov", traversal.camera.hfov_deg, "Horizontal field of view, degrees")
      ->capture_default_str();
  command->callback([options] {
    DriveAndRecord(*options);
  });
}

}  // namespace bulletnav::bench
