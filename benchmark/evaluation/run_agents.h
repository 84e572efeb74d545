// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "agent/registry.h"
#include "benchmark/evaluation/episode_run.h"
#include "benchmark/evaluation/privileged/ground_truth.h"
#include "benchmark/evaluation/privileged/privileged_agent.h"
#include "benchmark/evaluation/run_config.h"
#include "benchmark/evaluation/summary.h"

namespace bulletnav::bench {

/// Makes a semantic model from a file of weights; see agent::LearnedModel. May be called from
/// several threads.
using ModelLoader = std::function<std::shared_ptr<agent::SemanticModel>(
    const std::filesystem::path& weights, const agent::Rig& rig)>;

/// A loader that finds out whether there are weights that the rig can use, and no more: its models
/// cannot be asked anything. For programs without torch.
ModelLoader WeightsCheck();

/// The file of weights itself or, where a relative path is not found from the current folder, the
/// project's of that name. Throws FileError if there is none.
std::filesystem::path FindWeights(const std::string& weights);

/// The weights that a config's agents use, by name of the setting; without those that are missing.
std::map<std::string, std::filesystem::path> UsedWeights(const RunConfig& config);

/// An agent of a run: ready to be built, or known to be missing.
struct RunAgent {
  AgentEntry entry;
  std::vector<Setting> settings;  // in which it can run
  std::string missing;            // why it cannot run in the others, or at all; empty if it can
  bool is_privileged = false;
  std::string parameters;   // YAML text: nodes are not to be shared between threads
  agent::AgentMaker maker;  // of those that are not privileged
  WeightsSpec weights;
  ModelLoader load_model;

  bool is_learned() const { return entry.semantic_model == SemanticModelKind::kLearned; }
  /// How tables speak of it.
  AgentRow row() const;
};

/// Finds out, by building each agent once in each of its settings, what can run.
std::vector<RunAgent> FindAgents(const RunConfig& config,
                                 const ModelLoader& load_model = WeightsCheck());

/// Throws sim::Error that names every agent that cannot run in all of its settings.
void RequireAll(std::span<const RunAgent> agents);

/// What the bodies of a run carry.
agent::Rig RigOf(const RunConfig& config, Setting setting);

/// How the episodes of a run are played. `sees`: the agent is shown panoramas.
EpisodeRules RulesOf(const RunConfig& config, Setting setting, Condition condition, bool sees);

/// Builds an agent with one lane for each of `truths`, which must outlive it and be up to date at
/// every call; only oracles and privileged agents look at them. May be called from several threads.
std::unique_ptr<agent::BatchAgent> Build(const RunAgent& agent, const agent::Rig& rig,
                                         std::span<const GroundTruth* const> truths);

}  // namespace bulletnav::bench
