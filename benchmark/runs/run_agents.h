// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "agent/registry.h"
#include "benchmark/play/episode_run.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/privileged/privileged_agent.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// Make learned functions from files of weights; see agent::LearnedModel and agent::LearnedMapper.
/// May be called from several threads. Empty: this program has none.
struct ModelLoaders {
  template <class Model>
  using Loader = std::function<std::shared_ptr<Model>(const std::filesystem::path& weights,
                                                      const agent::Rig& rig)>;
  Loader<agent::SemanticModel> semantic_model;
  Loader<agent::FreeSpaceModel> mapper;

  explicit operator bool() const { return semantic_model && mapper; }
};

/// Loaders that find out whether there are weights that the rig can use, and no more: their models
/// cannot be asked anything. For programs without torch.
ModelLoaders WeightsCheck();

/// The file of weights itself or, where a relative path is not found from the current folder, the
/// project's of that name. Throws FileError if there is none.
std::filesystem::path FindWeights(const std::string& weights);

/// The weights that a config's agents use, by their key in `weights`; without those that are
/// missing.
std::map<std::string, std::filesystem::path> UsedWeights(const RunConfig& config);

/// An agent of a run: ready to be built, or known to be missing.
struct RunAgent {
  AgentEntry entry;
  std::vector<Setting> settings;  // in which it can run
  std::string missing;            // why it cannot run in the others, or at all; empty if it can
  std::string damage;             // of weights that are there but cannot be used
  bool is_privileged = false;
  std::string parameters;   // YAML text: nodes are not to be shared between threads
  agent::AgentMaker maker;  // of those that are not privileged
  WeightsSpec weights;
  std::map<std::string, std::int64_t> frames_trained;  // see AgentRow
  ModelLoaders loaders;

  bool is_learned() const { return entry.semantic_model == SemanticModelKind::kLearned; }
  /// Whether it needs a program with the learned functions where it can run.
  bool needs_torch() const;
  /// How tables speak of it.
  AgentRow row() const;
};

/// Finds out, by building each agent once in each of its settings, what can run.
std::vector<RunAgent> FindAgents(const RunConfig& config,
                                 const ModelLoaders& loaders = WeightsCheck());

/// Names and reasons of those that cannot run in all of their settings.
std::vector<std::string> MissingAgents(std::span<const RunAgent> agents);

/// Throws sim::Error if none can run, or the weights of one are damaged.
void RequireSome(std::span<const RunAgent> agents);

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
