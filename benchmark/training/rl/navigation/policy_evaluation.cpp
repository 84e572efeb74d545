// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/policy_evaluation.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/policy/policy_file.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/navigation/policy_validation.h"
#include "sim/base/error.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kAsItIs = "as it is";

std::vector<std::string> SettingsOf(const PolicyEvaluationConfig& config,
                                    const agent::TensorFile& content,
                                    const std::filesystem::path& weights) {
  const std::string trained = agent::TrainedSetting(content, weights);
  const std::string setting = config.setting ? std::string(sim::NameOf(*config.setting)) : trained;
  if (setting == sim::NameOf(LaneSetting::kBoth)) return {"rgb", "rgbd"};
  return {setting.empty() ? "rgbd" : setting};
}

Task TaskOf(const PolicyEvaluationConfig& config, int step_limit) {
  Task task;
  task.noise = config.noise;
  task.sensor_noise = sim::NamedSensorNoise(config.sensor_noise.value_or("none"));
  task.max_steps = step_limit;
  return task;
}

std::shared_ptr<agent::PolicyModel> Load(const std::filesystem::path& weights, const Task& task,
                                         bool has_depth) {
  agent::Rig rig = RigOf(task);
  rig.has_depth = has_depth;
  auto policy = std::dynamic_pointer_cast<agent::PolicyModel>(agent::LoadModel(weights, rig));
  if (!policy) throw sim::FileError(weights, "", "does not hold the weights of a policy");
  return policy;
}

std::vector<std::pair<std::string, PolicyValidation::Way>> WaysOf(const PolicyTrials& trials,
                                                                  int rows) {
  std::vector<std::pair<std::string, PolicyValidation::Way>> ways;
  ways.emplace_back(kAsItIs, PolicyValidation::Way{});
  if (trials.shuffle_goals) {
    ways.emplace_back("shuffled goals", PolicyValidation::Way{});
    ways.back().second.shuffle_goals = true;
  }
  if (trials.blank_images) {
    ways.emplace_back("blank images", PolicyValidation::Way{});
    ways.back().second.blank_images = true;
  }
  if (trials.direct_images) {
    ways.emplace_back("direct images", PolicyValidation::Way{});
    ways.back().second.direct_rows = rows;
  }
  return ways;
}

}  // namespace

agent::PolicyAgent::Config UsualAgent(const std::filesystem::path& weights) {
  const agent::TensorFile file = agent::ReadTensorFile(weights);
  const auto task = file.metadata.find("task");
  const bool is_imitator = task != file.metadata.end() && task->second == "imitation";
  return is_imitator ? agent::kAfterImitation : agent::kAfterReward;
}

void PolicyEvaluationConfig::Validate() const {
  internal::RequireAtLeast(1, episodes, "episodes");
  sim::RequireSensorNoise(sensor_noise.value_or("none"));
}

std::vector<PolicyEvaluationRow> EvaluatePolicy(const PolicyEvaluationConfig& config,
                                                const std::filesystem::path& weights,
                                                const PolicyTrials& trials, int workers,
                                                const TrainContext& context) {
  if (trials.shuffle_goals && config.episodes < 2) {
    throw sim::Error("goals of one episode alone cannot be shuffled; play more episodes");
  }
  const agent::TensorFile content = agent::ReadTensorFile(weights);
  const std::vector<std::string> settings = SettingsOf(config, content, weights);
  int limit = 0;
  for (const std::string& setting : settings) {
    limit = Load(weights, Task{}, setting == "rgbd")->step_limit();
  }
  const Task task = TaskOf(config, limit);
  NavigationScenes scenes = LoadNavigationScenes(config.data, context, "loading scenes", workers);
  const PolicyValidation validation(&scenes, task, config.episodes);
  const agent::PolicyAgent::Config acting = config.agent ? *config.agent : UsualAgent(weights);
  const int rows = agent::PolicyConfigOf(content, weights).rows;
  sim::WorkerPool pool(workers);
  std::vector<PolicyEvaluationRow> table;
  for (const std::string& setting : settings) {
    for (auto [trial, way] : WaysOf(trials, rows)) {
      way.with_depth = setting == "rgbd";
      way.pool = &pool;
      way.agent = acting;
      Measures measures;
      validation.Measure(
          [&, has_depth = way.with_depth] {
            return Load(weights, task, has_depth);
          },
          way, &measures);
      table.push_back({setting, trial, measures});
    }
  }
  return table;
}

std::string ToText(const std::vector<PolicyEvaluationRow>& rows) {
  std::string text = fmt::format("{:<6}{:<16}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>9}\n", "", "",
                                 "success", "easy", "medium", "hard", "SPL", "steps", "stopped");
  double success = 0.0;
  for (const PolicyEvaluationRow& row : rows) {
    const auto of = [&](const char* name) {
      return row.measures.at(name);
    };
    text +=
        fmt::format("{:<6}{:<16}{:>8.3f}{:>8.3f}{:>8.3f}{:>8.3f}{:>8.3f}{:>8.0f}{:>9.3f}",
                    row.setting, row.trial, of("success"), of("success_easy"), of("success_medium"),
                    of("success_hard"), of("spl"), of("steps"), of("stopped"));
    if (row.trial == kAsItIs) {
      success = of("success");
    } else if (success > 0.0) {
      const double lost = 100.0 * (1.0 - of("success") / success);
      text += fmt::format("   {} {:.0f}%", lost < 0.0 ? "gains" : "loses", std::abs(lost));
    }
    text += '\n';
  }
  return text;
}

std::string ToJson(const std::vector<PolicyEvaluationRow>& rows) {
  std::string text = "[";
  for (const PolicyEvaluationRow& row : rows) {
    text += fmt::format("{}{{\"setting\": \"{}\", \"trial\": \"{}\"", text.size() > 1 ? ",\n " : "",
                        row.setting, row.trial);
    for (const Measures::Item& item : row.measures.items()) {
      text += fmt::format(", \"{}\": {}", item.name, item.value);
    }
    text += "}";
  }
  return text + "]\n";
}

}  // namespace bulletnav::bench
