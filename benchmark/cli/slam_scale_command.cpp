// SPDX-License-Identifier: MIT
// Finding places among ever more frames. It is in bulletnav-slam.so; see slam.h.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/out_option.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/slam/io/recorded_frame.h"
#include "benchmark/slam/plots/scale_chart.h"
#include "benchmark/slam/scale/run_scale.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfig = "config.yaml";

struct ScaleOptions {
  fs::path config;
  fs::path out;
  std::vector<std::string> overrides;
  int workers = 0;
};

/// Results of anything else are left alone.
void CheckFolder(const ScaleConfig& config, const fs::path& folder) {
  ExpectNoRecording(folder);
  const fs::path file = folder / kConfig;
  if (!fs::exists(file) || sim::ReadTextFile(file) == sim::ToYaml(config)) return;
  throw sim::FileError(file, "",
                       "is of something else than this measurement; choose another --out");
}

void MeasureScale(const ScaleOptions& options) {
  const ScaleConfig config = LoadScaleConfig(ShippedConfig(options.config), options.overrides);
  const fs::path folder = options.out.empty() ? fs::path("results") / config.name : options.out;
  CheckFolder(config, folder);
  const PlayedScale played = PlayScale(config, options.workers, StartLine);
  const std::string table = ScaleTable(played);
  sim::MakeFolder(folder);
  sim::WriteFileAtomically(folder / kConfig, sim::ToYaml(config));
  sim::WriteFileAtomically(folder / "result.yaml", sim::ToYaml(played.result));
  sim::WriteFileAtomically(folder / "times.yaml", sim::ToYaml(played.times));
  sim::WriteFileAtomically(folder / "table.md", table);
  WriteFigure(ScaleFigure(played.result), folder / "recall");
  fmt::print("{}", table);
  fmt::print(stderr, "the program has {:.0f} MB in use; results: {}\n", played.times.resident_mb,
             folder.string());
}

}  // namespace

void AddSlamScaleCommand(CLI::App* slam) {
  auto options = std::make_shared<ScaleOptions>();
  CLI::App* command = slam->add_subcommand(
      "scale", "Measure how finding a place fares among ever more frames: recall, time, memory");
  command->add_option("config", options->config, "YAML file, as configs/slam/scale.yaml")
      ->required();
  command->add_option("overrides", options->overrides,
                      "KEY=VALUE ...: set in the config, as sizes=[1000]");
  AddResultsOption(command, &options->out);
  command->add_option("--workers", options->workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command->callback([options] {
    MeasureScale(*options);
  });
}

}  // namespace bulletnav::bench
