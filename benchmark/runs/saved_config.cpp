// SPDX-License-Identifier: MIT
#include "benchmark/runs/saved_config.h"

#include <string>
#include <utility>

namespace bulletnav::bench {
namespace {

/// Until 0.1, weights went by the setting, or were the mapper's.
void RenameWeights(YAML::Node weights) {
  if (!weights || !weights.IsMap()) return;
  constexpr std::pair<const char*, const char*> kNames[] = {
      {"rgb", "nts_rgb"}, {"rgbd", "nts_rgbd"}, {"mapper", "mapper_rgb"}};
  for (const auto& [old, now] : kNames) {
    if (!weights[old]) continue;
    weights[now] = weights[old].as<std::string>();
    weights.remove(old);
  }
}

/// And `semantic_model` was a key of its own.
void MoveModels(YAML::Node agent) {
  if (!agent.IsMap() || !agent["semantic_model"]) return;
  const auto model = agent["semantic_model"].as<std::string>();
  agent.remove("semantic_model");
  if (model != "none") agent["models"]["semantic_model"] = model;
}

}  // namespace

void BringUpToDate(YAML::Node config) {
  if (!config.IsMap()) return;
  if (config["agents"] && config["agents"].IsSequence()) {
    for (YAML::Node agent : config["agents"]) MoveModels(agent);
  }
  config.remove("time_budget");  // agents are no longer timed
  if (config["weights"]) RenameWeights(config["weights"]);
  if (config["fingerprints"] && config["fingerprints"].IsMap()) {
    RenameWeights(config["fingerprints"]["weights"]);
  }
}

}  // namespace bulletnav::bench
