// SPDX-License-Identifier: MIT
#include "benchmark/training/core/registry.h"

#include <map>
#include <utility>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// Filled before main by the registrations and only read after that.
std::map<std::string, internal::TrainerMaker, std::less<>>& Registered() {
  static std::map<std::string, internal::TrainerMaker, std::less<>> trainers;
  return trainers;
}

std::string UnknownName(std::string_view name) {
  std::string known;
  for (const std::string& other : TrainerNames()) known += (known.empty() ? "" : ", ") + other;
  return "unknown task '" + std::string(name) + "'; known are: " + known;
}

}  // namespace

std::vector<std::string> TrainerNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : Registered()) names.push_back(name);
  return names;
}

TrainJob MakeTraining(const sim::YamlNode& config, std::string_view default_task,
                      const TrainContext& context) {
  config.ExpectMap();
  const YAML::Node& map = config.yaml();
  const std::string task =
      map["task"] ? config.Child(map["task"]).ToString() : std::string(default_task);
  const auto found = Registered().find(task);
  if (found == Registered().end()) config.FailAt("task", UnknownName(task));
  return found->second(config, context);
}

void internal::RegisterTrainer(std::string_view name, TrainerMaker maker) {
  if (!Registered().try_emplace(std::string(name), std::move(maker)).second) {
    throw sim::Error("two trainers are called '" + std::string(name) + "'");
  }
}

}  // namespace bulletnav::bench
