// SPDX-License-Identifier: MIT
#include "benchmark/runs/agent_models.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/models/usual_slots.h"
#include "agent/registry.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/privileged/oracle_semantic_model.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// The key of learned weights: those for the setting, else those for all settings. A setting of the
/// config's own that has neither takes those for what its panoramas hold.
std::string WeightsKey(const std::string& weights, const RunConfig& config,
                       const std::string& setting) {
  std::string own = weights + "_" + setting;
  if (config.weights.contains(own) || FindShipped(config.weights_file(own))) return own;
  if (FindShipped(config.weights_file(weights))) return weights;
  if (!config.sensors.contains(setting)) return own;
  return weights + (RigOf(config, setting).has_depth ? "_rgbd" : "_rgb");
}

SlotSource SourceOf(agent::ModelSlot slot, const std::string& given, const RunConfig& config,
                    const std::string& setting) {
  SlotSource source{std::move(slot), given == kOracleModel, "", "", std::nullopt};
  if (source.is_oracle) return source;
  if (given == kLearnedModel) {
    source.key = WeightsKey(source.slot.weights, config, setting);
    source.name = config.weights_file(source.key);
  } else {
    source.key = given;
    source.name = given;
  }
  source.file = FindShipped(source.name);
  return source;
}

/// The keys of weights that some agent of this version may ask for in a setting.
std::set<std::string> KeysIn(const RunConfig& config, const std::string& setting) {
  const agent::Rig rig = RigOf(config, setting);
  std::set<std::string> keys;
  for (const std::string& agent : agent::AgentNames()) {
    for (const agent::ModelSlot& slot : agent::ModelSlotsOf(agent, rig)) {
      keys.insert({slot.weights, slot.weights + "_" + setting});
    }
  }
  return keys;
}

std::shared_ptr<agent::Model> LoadInto(const SlotSource& source, const agent::Rig& rig) {
  const fs::path file = FindWeights(source.name);
  std::shared_ptr<agent::Model> model = agent::LoadModel(file, rig);
  if (source.slot.accepts(*model)) return model;
  throw sim::FileError(
      file, "",
      "holds no " + source.slot.interface + ", which '" + source.slot.name +
          "' takes; name other weights for it in 'weights' or the agent's 'models'");
}

/// Takes an agent's oracle, or some functions of it in the place of the model's.
void AddOracles(const AgentEntry& entry, std::span<const SlotSource> sources,
                const GroundTruth& truth, agent::Models* models) {
  for (const SlotSource& source : sources) {
    const bool takes_functions =
        source.slot.name == agent::kSemanticModel && !entry.oracle_functions.empty();
    if (!source.is_oracle && !takes_functions) continue;
    const auto oracle = std::make_shared<OracleSemanticModel>(truth);
    if (!source.slot.accepts(*oracle)) {
      throw sim::Error("there is no oracle for '" + source.slot.name + "'");
    }
    if (source.is_oracle) {
      models->Set(source.slot.name, oracle);
      continue;
    }
    const auto& functions = entry.oracle_functions;
    models->Set(source.slot.name,
                std::make_shared<MixedSemanticModel>(
                    models->Need<agent::SemanticModel>(source.slot.name), oracle,
                    std::set<SemanticFunction>(functions.begin(), functions.end())));
  }
}

}  // namespace

std::vector<SlotSource> SourcesOf(const AgentEntry& entry, const RunConfig& config,
                                  const std::string& setting) {
  std::vector<SlotSource> sources;
  for (agent::ModelSlot& slot : agent::ModelSlotsOf(entry.agent, RigOf(config, setting))) {
    const auto given = entry.models.find(slot.name);
    const std::string model = given == entry.models.end() ? kLearnedModel : given->second;
    if (model == kNoModel) continue;
    SlotSource source = SourceOf(std::move(slot), model, config, setting);
    const bool is_left_out = !source.is_oracle && !source.file && !source.slot.is_needed;
    if (!is_left_out) sources.push_back(std::move(source));
  }
  return sources;
}

std::map<std::string, fs::path> UsedWeights(const RunConfig& config) {
  const std::vector<std::string> known = agent::AgentNames();
  std::map<std::string, fs::path> used;
  const auto note = [&](const AgentEntry& entry, const std::string& setting) {
    for (const SlotSource& source : SourcesOf(entry, config, setting)) {
      if (source.file) used[source.key] = *source.file;
    }
  };
  for (const AgentEntry& entry : config.agents) {
    if (std::find(known.begin(), known.end(), entry.agent) == known.end()) continue;
    const auto& settings = entry.settings.empty() ? config.settings : entry.settings;
    for (const std::string& setting : settings) note(entry, setting);
  }
  return used;
}

void RequireKnownWeights(const RunConfig& config) {
  std::set<std::string> settings(config.settings.begin(), config.settings.end());
  settings.insert({"rgb", "rgbd"});
  std::set<std::string> known;
  for (const std::string& setting : settings) known.merge(KeysIn(config, setting));
  for (const auto& [key, file] : config.weights) {
    if (known.contains(key)) continue;
    throw sim::Error(fmt::format("weights: no agent asks for '{}'; known here: {}", key,
                                 fmt::join(known, ", ")));
  }
}

bool ActsInFloats(const RunConfig& config) {
  const std::map<std::string, fs::path> used = UsedWeights(config);
  return std::any_of(used.begin(), used.end(), [](const auto& entry) {
    return !agent::HoldsIntegers(agent::ReadTensorFile(entry.second));
  });
}

fs::path FindWeights(const std::string& weights) {
  if (const auto file = FindShipped(weights)) return *file;
  throw sim::FileError(weights, "",
                       "does not exist; docs/training.md says which command trains it");
}

std::vector<agent::AgentContext> ContextsOf(const AgentEntry& entry,
                                            std::span<const SlotSource> sources,
                                            const agent::Rig& rig,
                                            std::span<const GroundTruth* const> truths) {
  agent::AgentContext shared{rig};
  for (const SlotSource& source : sources) {
    if (!source.is_oracle) shared.models.Set(source.slot.name, LoadInto(source, rig));
  }
  std::vector<agent::AgentContext> contexts(truths.size(), shared);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    AddOracles(entry, sources, *truths[i], &contexts[i].models);
  }
  return contexts;
}

}  // namespace bulletnav::bench
