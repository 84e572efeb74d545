// SPDX-License-Identifier: MIT
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/training/mapper_trainer.h"
#include "benchmark/training/nts_trainer.h"
#include "benchmark/training/scene_batches.h"
#include "benchmark/training/training_log.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kTrainSeed = 0;  // added to the config's
constexpr std::uint64_t kValidationSeed = 1'000'003;

SceneBatches Batches(const TrainPlan& plan, const DataConfig& data, bool with_depth,
                     double near_batches, std::uint64_t seed) {
  const auto scenes = static_cast<int>(ScenesOf(data).size());
  const auto labelled = StartLine("labelling scenes", scenes);
  std::function<void()> loaded;
  BatchesProgress progress;
  progress.on_labelled = [&](const LabelledScene& scene) {
    if (!scene.note.empty()) fmt::print(stderr, "{}\n", scene.note);
    labelled();
  };
  progress.on_loading = [&] {
    loaded = StartLine("loading scenes", scenes);
  };
  progress.on_loaded = [&] {
    loaded();
  };
  return {data, {plan.panoramas, with_depth, near_batches, plan.seed + seed}, progress};
}

void Train(const std::filesystem::path& file, const TrainTask& task, bool with_depth) {
  const TrainPlan& plan = task.plan;
  if (!plan.data) throw sim::FileError(file, "", "has no block 'data'; see configs/train");
  for (const DataConfig& data : {*plan.data, ValidationData(plan)}) {
    MakeHousesOf(data, CommittedVersion(), 0, StartLine);
  }
  const SceneBatches train =
      Batches(plan, *plan.data, with_depth, plan.near_batches.value_or(0.0), kTrainSeed);
  const SceneBatches validation =
      Batches(plan, ValidationData(plan), with_depth, 0.0, kValidationSeed);
  TrainingLog log(plan, &std::cerr);
  RunTraining(task, train, validation, &log);
  fmt::print("weights and curves: {}\n", plan.out);
}

void Train(const std::filesystem::path& file) {
  switch (TrainedBy(file)) {
    case Trained::kNts: {
      const auto config = sim::LoadYaml<TrainConfig>(file);
      return Train(file, NtsTask(config), config.model.uses_depth());
    }
    case Trained::kMapper:
      return Train(file, MapperTask(sim::LoadYaml<MapperTrainConfig>(file)), true);
  }
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  auto file = std::make_shared<std::filesystem::path>();
  CLI::App* command = program->add_subcommand(
      "train",
      "Train the learned functions of Neural Topological SLAM or the mapper for colour; goes on "
      "after a kill");
  command->add_option("config", *file, "YAML file, as configs/train/nts_rgbd.yaml")->required();
  command->callback([file] {
    Train(*file);
  });
}

}  // namespace bulletnav::bench
