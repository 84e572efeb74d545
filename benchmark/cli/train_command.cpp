// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/cli/stop_note.h"
#include "benchmark/training/core/checkpoint.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/core/training_log.h"
#include "sim/config/override.h"

namespace bulletnav::bench {
namespace {

/// Of configs that were written when there was no key `task`.
constexpr const char* kDefaultTask = "nts";

/// Hears what the first process tells.
class Silent final : public TrainObserver {
 public:
  void Resumed(int /*step*/) override {}
  void Stepped(int /*step*/, double /*loss*/) override {}
  void Validated(int, const Measures&, const std::string&) override {}
};

void TrainTogether(const sim::YamlNode& config, const std::shared_ptr<Peers>& peers) {
  TrainContext context;
  if (peers->is_first()) context.start = StartLine;
  context.peers = peers;
  const TrainJob job = MakeTraining(config, kDefaultTask, context);
  if (!peers->is_first()) {
    Silent silent;
    RunTraining(job, &silent, peers.get());
    return;
  }
  TrainingLog log(job, &std::cerr);
  RunTraining(job, &log, peers.get());
  fmt::print("weights and curves: {}\n", job.plan.out);
}

/// Where what a training goes on from will be; nowhere if the config does not say, which is an
/// error that is told later.
std::filesystem::path CheckpointOf(const sim::YamlNode& config) {
  if (!config.yaml().IsMap()) return {};
  const YAML::Node out = config.yaml()["out"];
  if (!out || !out.IsScalar()) return {};
  return std::filesystem::path(out.Scalar()) / kCheckpointFile;
}

void Train(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const sim::YamlNode config = sim::ReadWithOverrides(file, overrides);
  const StopNote note([checkpoint = CheckpointOf(config)] {
    return std::filesystem::exists(checkpoint)
               ? std::string("the same command goes on from what was saved last")
               : std::string("nothing is saved yet; the same command begins anew");
  });
  const auto peers = std::make_shared<Peers>(PeerPlaceOf([](const char* name) {
    return static_cast<const char*>(std::getenv(name));
  }));
  try {
    TrainTogether(config, peers);
  } catch (const std::exception& error) {
    peers->Leave(error.what());
    throw;
  }
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  auto file = std::make_shared<std::filesystem::path>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  CLI::App* command = program->add_subcommand(
      "train",
      "Train the networks that agents use, each by the task that its config names; goes on after a "
      "kill");
  command->add_option("config", *file, "YAML file, as configs/train/nts_rgbd.yaml")->required();
  command->add_option("overrides", *overrides,
                      "KEY=VALUE ...: set in the config, as steps=100 or data.seed=2");
  command->callback([file, overrides] {
    Train(ShippedConfig(*file), *overrides);
  });
}

}  // namespace bulletnav::bench
