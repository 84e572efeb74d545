// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agent/registry.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/play/task.h"
#include "benchmark/privileged/privileged_agent.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// An agent of a run: ready to be built, or known to be missing.
struct RunAgent {
  AgentEntry entry;
  std::vector<std::string> settings;  // in which it can run
  std::string missing;                // why it cannot run in the others, or at all; empty if it can
  std::string damage;                 // of weights that are there but cannot be used
  bool is_privileged = false;
  std::string parameters;   // YAML text: nodes are not to be shared between threads
  agent::AgentMaker maker;  // of those that are not privileged
  std::map<std::string, std::vector<SlotSource>> models;
  std::map<std::string, std::int64_t> frames_trained;  // see AgentRow
  std::string source;  // hash of the code of an agent::ForeignAgent; empty for others

  /// How tables speak of it.
  AgentRow row() const;
};

/// Finds out, by building each agent once in each of its settings, what can run.
std::vector<RunAgent> FindAgents(const RunConfig& config);

/// Names and reasons of those that cannot run in all of their settings.
std::vector<std::string> MissingAgents(std::span<const RunAgent> agents);

/// Throws sim::Error if none can run, or the weights of one are damaged.
void RequireSome(std::span<const RunAgent> agents);

/// Throws sim::Error that names every agent that cannot run in all of its settings.
void RequireAll(std::span<const RunAgent> agents);

/// What Fingerprints::sources are of these agents; absent if none is foreign.
std::optional<std::map<std::string, std::string>> SourceHashes(std::span<const RunAgent> agents);

/// Throws sim::Error, naming the agent, if `saved` tells of other code than there is now.
void RequireSameSources(const std::optional<Fingerprints>& saved, std::span<const RunAgent> agents);

/// What the episodes of a run ask for. `sees`: the agent is shown panoramas.
Task TaskOf(const RunConfig& config, const std::string& setting, Condition condition, bool sees);

/// Builds an agent with one lane for each of `truths`, which must outlive it and be up to date at
/// every call; only oracles and privileged agents look at them. May be called from several threads.
std::unique_ptr<agent::BatchAgent> Build(const RunAgent& agent, const RunConfig& config,
                                         const std::string& setting,
                                         std::span<const GroundTruth* const> truths);

}  // namespace bulletnav::bench
