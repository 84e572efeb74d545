// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/training/core/trainer.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// What a training is built with, besides its config.
struct TrainContext {
  /// Starts a line of progress: what, and of how many; the answer is called for each that is done.
  std::function<std::function<void()>(const std::string& what, int total)> start;
  std::shared_ptr<Peers> peers = nullptr;  // that train together with this process; null: alone
};

/// Names of all registered trainers, in alphabetical order.
std::vector<std::string> TrainerNames();

/// The training that a config's key `task` names; without that key, `default_task`. Reads its data.
/// Throws FileError at file:line:column for an unknown name, listing the known ones, and for a bad
/// config; Error if the device is missing, and what the task throws.
TrainJob MakeTraining(const sim::YamlNode& config, std::string_view default_task,
                      const TrainContext& context);

namespace internal {

using TrainerMaker = std::function<TrainJob(const sim::YamlNode&, const TrainContext&)>;
/// Throws Error if the name is taken.
void RegisterTrainer(std::string_view name, TrainerMaker maker);

}  // namespace internal

/// Makes training T known by its name. One constant of this type at the end of T's file does it.
template <class T>
class TrainerRegistration {
 public:
  TrainerRegistration() {
    internal::RegisterTrainer(T::kName, [](const sim::YamlNode& yaml, const TrainContext& context) {
      typename T::Config config;
      sim::YamlReader::Read(yaml, config);
      try {
        RequireDevice(config, config.heeds_device());
        return TrainJob::Of<T>(config, std::make_unique<T>(config, context));
      } catch (const sim::KeyError& e) {
        yaml.FailAt(e.key(), e.what());
      }
    });
  }
};

}  // namespace bulletnav::bench
