// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
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
#include "sim/base/error.h"
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

struct TrainWords {
  std::vector<std::filesystem::path> configs;  // one at least
  std::vector<std::string> overrides;
};

/// The first word is a config, others with "=" are set in each.
TrainWords Sorted(const std::vector<std::string>& words) {
  TrainWords sorted;
  for (const std::string& word : words) {
    const bool is_override = !sorted.configs.empty() && word.find('=') != std::string::npos;
    if (is_override) {
      sorted.overrides.push_back(word);
    } else {
      sorted.configs.push_back(ShippedConfig(word));
    }
  }
  return sorted;
}

/// All are read before the first begins, so that what is wrong in the last is not told hours later.
std::vector<sim::YamlNode> ReadAll(const TrainWords& words) {
  std::vector<sim::YamlNode> configs;
  std::map<std::filesystem::path, std::filesystem::path> config_of;  // by checkpoint
  configs.reserve(words.configs.size());
  for (const std::filesystem::path& file : words.configs) {
    configs.push_back(sim::ReadWithOverrides(file, words.overrides));
    const std::filesystem::path checkpoint = CheckpointOf(configs.back());
    const auto [other, is_new] = config_of.emplace(checkpoint, file);
    if (is_new || checkpoint.empty()) continue;
    throw sim::FileError(file, "",
                         fmt::format("trains into {}, as {} does; give each an 'out' of its own",
                                     checkpoint.parent_path().string(), other->second.string()));
  }
  return configs;
}

void TrainNoted(const sim::YamlNode& config, const std::shared_ptr<Peers>& peers) {
  const StopNote note([checkpoint = CheckpointOf(config)] {
    return std::filesystem::exists(checkpoint)
               ? std::string("the same command goes on from what was saved last")
               : std::string("nothing is saved yet; the same command begins anew");
  });
  TrainTogether(config, peers);
}

void Train(const TrainWords& words) {
  const std::vector<sim::YamlNode> configs = ReadAll(words);
  const PeerPlace place = PeerPlaceOf([](const char* name) {
    return static_cast<const char*>(std::getenv(name));
  });
  if (place.size > 1) {
    fmt::print(stderr, "process {} of {} waits for the others, {} s at most\n", place.rank,
               place.size, place.timeout_s);
  }
  const auto peers = std::make_shared<Peers>(place);
  try {
    for (const sim::YamlNode& config : configs) TrainNoted(config, peers);
  } catch (const std::exception& error) {
    peers->Leave(error.what());
    throw;
  }
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = program->add_subcommand("train",
                                              "Train the networks that agents use, each by the "
                                              "task that its config names, one config after "
                                              "the other; goes on after a kill");
  command
      ->add_option("config", *words,
                   "YAML files, as configs/train/nts_rgbd.yaml, and KEY=VALUE ..., set in each, as "
                   "steps=100 or data.seed=2")
      ->required();
  command->callback([words] {
    Train(Sorted(*words));
  });
}

}  // namespace bulletnav::bench
