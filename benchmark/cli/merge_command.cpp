// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/tell_outcome.h"
#include "benchmark/runs/merge_shards.h"

namespace bulletnav::bench {

void AddMergeCommand(CLI::App* program) {
  auto folder = std::make_shared<std::filesystem::path>();
  CLI::App* command = program->add_subcommand(
      "merge", "Join the shards of a run into what one process would have written");
  command->add_option("folder", *folder, "Folder of results, as --out of the shards")->required();
  command->callback([folder] {
    TellOutcome(MergeShards(*folder));
    fmt::print("to draw episodes: ./bulletnav plot {}\n", folder->string());
  });
}

}  // namespace bulletnav::bench
