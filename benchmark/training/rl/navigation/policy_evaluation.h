// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "agent/policy/policy_agent.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/navigation/navigation_lanes.h"

namespace bulletnav::bench {

/// Where a learned policy is tried, and how: the config of `evaluate-policy`.
struct PolicyEvaluationConfig {
  std::string weights;
  NavigationData data;
  int episodes = 60;                   // in each setting
  std::optional<LaneSetting> setting;  // default: what the weights were trained in, else rgbd
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  std::optional<std::string> sensor_noise;  // of cameras, see sim::NamedSensorNoise; default: none
  std::optional<agent::PolicyAgent::Config> agent;  // default: UsualAgent

  template <class V>
  void Visit(V& v) {
    v.Required("weights", weights);
    v.Required("data", data);
    v("episodes", episodes);
    v("setting", setting);
    v("noise", noise);
    v("sensor_noise", sensor_noise);
    v("agent", agent);
  }
  /// Throws Error.
  void Validate() const;
};

/// How the agent acts in runs that such weights are of, by the task of their training. Throws
/// FileError if they cannot be read.
agent::PolicyAgent::Config UsualAgent(const std::filesystem::path& weights);

/// Beside the episodes as they are: what a policy must fail at, and what it should not.
struct PolicyTrials {
  bool shuffle_goals = false;  // of another episode
  bool blank_images = false;   // black, and of no depth
  bool direct_images = false;  // drawn in the policy's size, see PolicyValidation::Way::direct_rows
};

struct PolicyEvaluationRow {
  std::string setting;  // "rgb" or "rgbd"
  std::string trial;    // "as it is", "shuffled goals", "blank images" or "direct images"
  Measures measures;
};

/// Plays the episodes with the policy in `weights`, as agents load it. Makes houses that are not
/// there. The same for any number of threads. Throws FileError if the weights are no policy's.
std::vector<PolicyEvaluationRow> EvaluatePolicy(const PolicyEvaluationConfig& config,
                                                const std::filesystem::path& weights,
                                                const PolicyTrials& trials, int workers,
                                                const TrainContext& context);

/// A table for people, with the share of its success that each trial takes from it.
std::string ToText(const std::vector<PolicyEvaluationRow>& rows);
std::string ToJson(const std::vector<PolicyEvaluationRow>& rows);

}  // namespace bulletnav::bench
