// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/training/nts_trainer.h"
#include "benchmark/training/scene_batches.h"
#include "benchmark/training/training_log.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kTrainSeed = 0;  // added to the config's
constexpr std::uint64_t kValidationSeed = 1'000'003;

SceneBatches Batches(const TrainConfig& config, const DataConfig& data, std::uint64_t seed) {
  const bool with_depth = config.model.depth != agent::DepthFusion::kNone;
  Progress progress("labelling scenes", static_cast<int>(ScenesOf(data).size()));
  return {data, config.panoramas, with_depth, config.seed + seed, [&](const LabelledScene& scene) {
            if (!scene.note.empty()) fmt::print(stderr, "{}\n", scene.note);
            progress.Advance();
          }};
}

void Train(const std::filesystem::path& file) {
  const auto config = sim::LoadYaml<TrainConfig>(file);
  if (!config.data) throw sim::FileError(file, "", "has no block 'data'; see configs/train");
  SceneBatches train = Batches(config, *config.data, kTrainSeed);
  SceneBatches validation = Batches(config, ValidationData(config), kValidationSeed);
  TrainingLog log(config, &std::cerr);
  TrainNts(config, train, validation, &log);
  fmt::print("weights and curves: {}\n", config.out);
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  auto file = std::make_shared<std::filesystem::path>();
  CLI::App* command = program->add_subcommand(
      "train", "Train the learned functions of Neural Topological SLAM; goes on after a kill");
  command->add_option("config", *file, "YAML file, as configs/train/nts_rgbd.yaml")->required();
  command->callback([file] {
    Train(*file);
  });
}

}  // namespace bulletnav::bench
