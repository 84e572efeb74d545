// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/training/core/trainer_registry.h"

namespace bulletnav::bench {

void AddTrainCommand(CLI::App* program) {
  auto file = std::make_shared<std::filesystem::path>();
  CLI::App* command = program->add_subcommand(
      "train", "Train what a config's key 'task' names; goes on after a kill");
  command->add_option("config", *file, "YAML file, as configs/train/nts_rgbd.yaml")->required();
  command->callback([file] {
    fmt::print("weights and curves: {}\n", RunTrainer(*file, {StartLine, &std::cerr}).string());
  });
}

}  // namespace bulletnav::bench
