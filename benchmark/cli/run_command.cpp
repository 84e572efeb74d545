// SPDX-License-Identifier: MIT
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/warn_line.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/draw_run.h"
#include "benchmark/cli/out_option.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/run_progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/cli/stop_note.h"
#include "benchmark/cli/tell_outcome.h"
#include "benchmark/report/run_tables.h"
#include "benchmark/runs/runner.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kWorstPlots = 4;

struct RunCommandOptions {
  fs::path config;
  fs::path out;
  RunOptions run;
  std::string shard;
  std::vector<std::string> overrides;
  bool no_plots = false;
};

/// As asked for, or of the Slurm array that this is a task of.
std::optional<Shard> ShardOf(const RunCommandOptions& options) {
  if (!options.run.only.empty()) return std::nullopt;
  if (!options.shard.empty()) return ParseShard(options.shard);
  const auto shard = ShardOfArray([](const char* name) {
    return std::getenv(name);
  });
  if (shard) {
    fmt::print(stderr, "note: --shard {}/{}, from SLURM_ARRAY_TASK_ID\n", shard->number, shard->of);
  }
  return shard;
}

void TellVersions(const fs::path& folder) {
  const int versions = CountVersions(folder);
  if (versions < 2) return;
  fmt::print(stderr,
             "note: {} versions of the program play these results ({}); for results of one, give "
             "--out another folder\n",
             versions, (folder / "versions.txt").string());
}

/// How far a run is, for when it is stopped.
struct RunCount {
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> total = 0;  // 0: it has not begun

  std::string Kept(const fs::path& folder) const {
    if (total == 0) return "before the first episode; the same command starts where it can go on";
    return fmt::format("{} of {} episodes are played and stay in {}; the same command goes on",
                       done.load(), total.load(), folder.string());
  }
};

RunHooks MakeHooks(const fs::path& folder, RunProgress* progress, RunCount* count) {
  RunHooks hooks;
  hooks.prepare = StartLine;
  hooks.warn = WarnLine;
  hooks.missing = [](std::span<const std::string> missing) {
    for (const std::string& one : missing) {
      WarnLine("not played: " + one);
    }
  };
  hooks.begin = [progress, count, folder](std::size_t total,
                                          std::span<const EpisodeResult> before) {
    count->done = before.size();
    count->total = total;
    if (before.size() < total) TellVersions(folder);
    progress->Begin(total, before);
  };
  hooks.finish = [progress, count](const EpisodeResult& result) {
    ++count->done;
    progress->Add(result);
  };
  return hooks;
}

/// How much room the beliefs take that a run has logged.
void TellBeliefs(const fs::path& folder) {
  std::size_t files = 0;
  double bytes = 0.0;
  std::error_code none;
  for (fs::recursive_directory_iterator at(folder / "beliefs", none), end; at != end; ++at) {
    if (!at->is_regular_file()) continue;
    ++files;
    bytes += static_cast<double>(at->file_size());
  }
  if (files == 0) return;
  fmt::print("beliefs of {}: {:.1f} MB ({})\n", Counted(files, "episode"), bytes / 1e6,
             (folder / "beliefs").string());
}

/// Draws what to look at first.
void DrawWorst(const fs::path& folder) {
  DrawOptions options;
  options.run = folder;
  std::error_code unreadable;
  if (fs::exists(folder / "trajectories", unreadable)) {
    options.choice.worst = kWorstPlots;
    options.belief = true;
  }
  const DrawnCount drawn = DrawRun(options);
  fmt::print("plots, the worst first: {} ({})\n", PlotFolder(options).string(), ToText(drawn));
}

void PlayConfig(RunCommandOptions options) {
  options.run.shard = ShardOf(options);
  RunConfig config = LoadRunConfig(ShippedConfig(options.config), options.overrides);
  const fs::path folder = options.out.empty() ? fs::path("results") / config.name : options.out;
  const fs::path place = options.run.shard ? ShardFolder(folder, *options.run.shard) : folder;
  RunProgress progress;
  RunCount count;
  const StopNote note([&] {
    return count.Kept(place);
  });
  const RunOutcome outcome =
      RunBenchmark(std::move(config), folder, options.run, MakeHooks(place, &progress, &count));
  progress.End();
  TellOutcome(outcome);
  if (!outcome.failures.empty()) {
    fmt::print(stderr, "to play failed episodes again: the same command with --retry-failed\n");
  }
  TellBeliefs(place);
  if (options.run.shard) {
    fmt::print("when all {} shards are done: ./bulletnav merge {}\n", options.run.shard->of,
               folder.string());
    return;
  }
  if (!options.no_plots) DrawWorst(folder);
  fmt::print("to draw others: ./bulletnav plot {}\n", folder.string());
  TellVersions(folder);
}

}  // namespace

void AddRunCommand(CLI::App* program) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = program->add_subcommand(
      "run", "Play a config's episodes with its agents; goes on where it was stopped");
  command->add_option("config", options->config, "YAML file, as configs/quickstart.yaml")
      ->required();
  command->add_option("overrides", options->overrides,
                      "KEY=VALUE ...: set in the config, as max_steps=100 or agents.0.lanes=2");
  command
      ->add_option("--episodes", options->run.episodes,
                   "Only so many, evenly over scenes and difficulties")
      ->check(CLI::Range(1, 100'000'000));
  command->add_option("--workers", options->run.workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  AddResultsOption(command, &options->out);
  command
      ->add_option("--shard", options->shard,
                   "I/N: only the I-th of N shares of the episodes, into a folder of its own below "
                   "that of results (default: of the Slurm array, in one)")
      ->check([](const std::string& text) {
        try {
          ParseShard(text);
        } catch (const sim::Error& e) {
          return std::string(e.what());
        }
        return std::string();
      });
  command
      ->add_option("--only", options->run.only, "Only the episode of this name (may be repeated)")
      ->allow_extra_args(false)
      ->excludes("--shard");
  command->add_flag("--no-plots", options->no_plots,
                    "Draw no charts and worst episodes at the end");
  command->add_flag("--beliefs", options->run.beliefs,
                    "Keep what agents believe at each step (map, graph, target) for replays");
  command->add_flag("--require-all", options->run.require_all,
                    "Agents that are missing are errors, not remarks in the table");
  command->add_flag("--retry-failed", options->run.retry_failed,
                    "Play episodes that failed (an agent threw, or took too long) again");
  command->callback([options] {
    PlayConfig(*options);
  });
}

void AddTableCommand(CLI::App* program) {
  auto folders = std::make_shared<std::vector<fs::path>>();
  CLI::App* command = program->add_subcommand(
      "table", "Make the tables and summary of results again, also while a run goes on");
  command->add_option("folders", *folders, "Folders of results")->required();
  command->callback([folders] {
    for (const fs::path& folder : *folders) {
      if (folders->size() > 1) fmt::print("# {}\n\n", folder.string());
      fmt::print("{}\n", RebuildTables(folder));
    }
  });
}

}  // namespace bulletnav::bench
