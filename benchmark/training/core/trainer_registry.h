// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/training/core/train_task.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// Whom a training tells how it goes.
struct TrainerContext {
  /// A part of the preparation begins: what, and how many there are. Returns what to call for each.
  std::function<std::function<void()>(const std::string& what, int total)> start =
      [](const std::string& /*what*/, int /*total*/) {
        return [] {};
      };
  std::ostream* log = nullptr;  // null: silent
};

/// Names of all registered trainers, in alphabetical order.
std::vector<std::string> TrainerNames();

/// Trains what a file's key `task` names (default: nts) until its steps are done; see RunTraining.
/// Returns the folder that it wrote to. Throws FileError at file:line:column for an unknown task,
/// listing the known ones, and for a bad config.
std::filesystem::path RunTrainer(const std::filesystem::path& file, const TrainerContext& context);

namespace internal {

/// Trains by a config; returns the folder.
using Train = std::function<std::filesystem::path(const sim::YamlNode&, const TrainerContext&)>;

/// Throws Error if the name is taken.
void RegisterTrainer(std::string_view name, Train train);

std::filesystem::path TrainTold(const TrainTask& task, const TrainerContext& context);

}  // namespace internal

/// Makes trainer T known by its name: one constant of this type at the end of its file does it. T
/// has `static constexpr std::string_view kName`, a nested struct `Config` that derives from
/// TrainPlan, and
///   static TrainTask Prepare(const Config& config, const TrainerContext& context);
/// which reads or makes what is learned from.
template <class T>
class TrainerRegistration {
 public:
  TrainerRegistration() {
    internal::RegisterTrainer(T::kName,
                              [](const sim::YamlNode& yaml, const TrainerContext& context) {
                                typename T::Config config;
                                sim::YamlReader::Read(yaml, config);
                                return internal::TrainTold(T::Prepare(config, context), context);
                              });
  }
};

}  // namespace bulletnav::bench
