// SPDX-License-Identifier: MIT
// The commands that play drives and show what came of them. They are in bulletnav-slam.so; see
// slam.h.
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
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "benchmark/slam/runs/slam_summary.h"
#include "benchmark/slam/runs/slam_table.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct SlamRunCommandOptions {
  fs::path config;
  fs::path out;
  std::vector<std::string> overrides;
  SlamRunOptions run;
  bool no_plots = false;
};

void ShowTables(const SlamConfig& config, const std::vector<DriveResult>& results,
                const fs::path& folder) {
  const std::string tables = SlamTables(config, results);
  fmt::print("{}", tables);
  sim::WriteFileAtomically(folder / "summary.json", ToJson(Summarise(config, results)));
  sim::WriteFileAtomically(folder / "table.md", tables);
  std::vector<TimesByStage> times;
  for (const Drive& drive : DrivesDone(config, folder)) {
    times.push_back(ReadDriveTimes(DriveFolder(folder, drive.name)));
  }
  const std::string took = SlamTimesTable(config, times);
  if (took.empty()) return;
  fmt::print("\n{}", took);
  sim::WriteFileAtomically(folder / "times.md", took);
}

void RunAndShow(SlamRunCommandOptions options) {
  const SlamConfig config = LoadSlamConfig(ShippedConfig(options.config), options.overrides);
  const fs::path folder = options.out.empty() ? fs::path("results") / config.name : options.out;
  options.run.progress = StartLine;
  const std::vector<DriveResult> results = RunSlam(config, folder, options.run);
  ShowTables(config, results, folder);
  if (!options.no_plots) DrawSlamRun(folder, SlamPictures::kAll);
  fmt::print(stderr, "results: {}\n", folder.string());
}

}  // namespace

void AddSlamRunCommand(CLI::App* slam) {
  auto options = std::make_shared<SlamRunCommandOptions>();
  CLI::App* command = slam->add_subcommand(
      "run", "Find loops in a config's drives, optimise, measure; goes on where it was stopped");
  command->add_option("config", options->config, "YAML file, as configs/slam/quickstart.yaml")
      ->required();
  command->add_option("overrides", options->overrides,
                      "KEY=VALUE ...: set in the config, as actions=[300] or apart_m=5");
  AddResultsOption(command, &options->out);
  command->add_flag("--no-plots", options->no_plots, "Draw nothing");
  command->add_option("--workers", options->run.workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command->callback([options] {
    RunAndShow(*options);
  });
}

void AddSlamTableCommand(CLI::App* slam) {
  auto folder = std::make_shared<fs::path>();
  CLI::App* command = slam->add_subcommand(
      "table", "Write table.md and summary.json of a run again, and print the tables");
  command->add_option("run", *folder, "Folder of results of slam run")->required();
  command->callback([folder] {
    const SlamConfig config = ReadSlamRun(*folder);
    ShowTables(config, ReadSlamResults(config, *folder), *folder);
  });
}

}  // namespace bulletnav::bench
