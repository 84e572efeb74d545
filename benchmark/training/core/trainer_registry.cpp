// SPDX-License-Identifier: MIT
#include "benchmark/training/core/trainer_registry.h"

#include <map>
#include <sstream>
#include <utility>

#include "benchmark/training/core/trainer.h"
#include "benchmark/training/core/training_log.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kDefault = "nts";

/// Filled before main by the registrations and only read after that.
std::map<std::string, internal::Train, std::less<>>& Registered() {
  static std::map<std::string, internal::Train, std::less<>> trainers;
  return trainers;
}

}  // namespace

std::vector<std::string> TrainerNames() {
  std::vector<std::string> names;
  for (const auto& [name, train] : Registered()) names.push_back(name);
  return names;
}

std::filesystem::path RunTrainer(const std::filesystem::path& file, const TrainerContext& context) {
  const sim::YamlNode root = sim::ParseYaml(sim::ReadYamlFile(file), file);
  root.ExpectMap();
  const YAML::Node& map = root.yaml();
  const std::string name = map["task"] ? root.Child(map["task"]).ToString() : kDefault;
  const auto found = Registered().find(name);
  if (found != Registered().end()) return found->second(root, context);
  std::string known;
  for (const std::string& other : TrainerNames()) known += (known.empty() ? "" : ", ") + other;
  root.FailAt("task", "nothing trains '" + name + "'; known are: " + known);
}

void internal::RegisterTrainer(std::string_view name, Train train) {
  if (!Registered().try_emplace(std::string(name), std::move(train)).second) {
    throw sim::Error("two trainers are called '" + std::string(name) + "'");
  }
}

std::filesystem::path internal::TrainTold(const TrainTask& task, const TrainerContext& context) {
  std::ostringstream nobody;
  TrainingLog log(task, context.log != nullptr ? context.log : &nobody);
  RunTraining(task, &log);
  return task.plan.out;
}

}  // namespace bulletnav::bench
