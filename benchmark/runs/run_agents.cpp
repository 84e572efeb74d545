// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_agents.h"

#include <algorithm>
#include <array>
#include <exception>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "agent/foreign_agent.h"
#include "agent/models/model_registry.h"
#include "benchmark/base/file_hash.h"
#include "sim/base/check.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

/// Privileged agents behind the interface of the others: they see the truth instead of what the
/// observations hold.
class PrivilegedLanes final : public agent::BatchAgent {
 public:
  PrivilegedLanes(std::vector<std::unique_ptr<PrivilegedAgent>> agents,
                  std::span<const GroundTruth* const> truths)
      : agents_(std::move(agents)), truths_(truths.begin(), truths.end()) {
    BULLETNAV_CHECK_EQ(agents_.size(), truths_.size());
  }

  int lanes() const override { return static_cast<int>(agents_.size()); }
  void Reset(int lane, const agent::Panorama& /*goal*/, std::uint64_t /*seed*/) override {
    const auto i = static_cast<std::size_t>(lane);
    agents_.at(i)->Reset(*truths_.at(i));
  }
  void NextGoal(int lane, const agent::Panorama& goal, std::uint64_t seed) override {
    Reset(lane, goal, seed);
  }
  void Act(std::span<const agent::LaneObservation> observations,
           std::span<sim::Action> actions) override {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const auto lane = static_cast<std::size_t>(observations[i].lane);
      actions[i] = agents_.at(lane)->Act(*truths_.at(lane));
    }
  }

 private:
  std::vector<std::unique_ptr<PrivilegedAgent>> agents_;
  std::vector<const GroundTruth*> truths_;
};

bool IsIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether results that were saved with this config are of the weights that are there now.
bool IsOfTheseWeights(const RunConfig& config, const std::string& key,
                      const std::filesystem::path& weights) {
  if (!config.fingerprints) return true;
  const auto saved = config.fingerprints->weights.find(key);
  return saved == config.fingerprints->weights.end() || saved->second == FileHash(weights);
}

/// Of all models that the agent takes from files.
void NoteFrames(const RunConfig& config, const std::string& setting, RunAgent* agent) {
  std::optional<std::int64_t> sum;
  for (const SlotSource& source : agent->models[setting]) {
    if (!source.file) continue;
    const auto frames = agent::FramesTrained(*source.file);
    if (!frames || !IsOfTheseWeights(config, source.key, *source.file)) return;
    sum = sum.value_or(0) + *frames;
  }
  if (sum) agent->frames_trained[setting] = *sum;
}

bool HasWeights(std::span<const SlotSource> sources) {
  return std::all_of(sources.begin(), sources.end(), [](const SlotSource& source) {
    return source.is_oracle || source.file;
  });
}

/// Of names and contents of the files of its code; empty if that is the program's.
std::string SourceHash(const agent::BatchAgent& agent) {
  const auto* const foreign = dynamic_cast<const agent::ForeignAgent*>(&agent);
  if (foreign == nullptr) return "";
  std::string facts;
  for (const std::filesystem::path& file : foreign->sources()) {
    facts += file.filename().string() + " " + FileHash(file) + "\n";
  }
  return fmt::format("{:016x}", sim::Hash64(facts));
}

/// Why the agent cannot be built; empty if it can. Weights that are there but cannot be used also
/// go into `damage`. Notes the hash of its code.
std::string WhyNot(const RunConfig& config, const std::string& setting, RunAgent* agent) {
  const GroundTruth nowhere;
  const std::array<const GroundTruth*, 1> truths = {&nowhere};
  try {
    agent->source = SourceHash(*Build(*agent, config, setting, truths));
  } catch (const sim::FileError& e) {
    if (!agent->is_privileged && HasWeights(agent->models.at(setting))) agent->damage = e.what();
    return e.what();
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "";
}

RunAgent FindAgent(const RunConfig& config, const AgentEntry& entry) {
  RunAgent agent;
  agent.entry = entry;
  if (entry.parameters) {
    sim::YamlWriter writer;
    writer.Write(*entry.parameters);
    agent.parameters = writer.text();
  }
  agent.missing = entry.trouble;
  if (!agent.missing.empty()) return agent;
  agent.is_privileged = IsIn(PrivilegedAgentNames(), entry.agent);
  if (!agent.is_privileged && !IsIn(agent::AgentNames(), entry.agent)) {
    agent.missing = "this version has no such agent yet";
    return agent;
  }
  if (!agent.is_privileged) agent.maker = agent::ConfigureAgent(entry.agent, entry.parameters);
  const auto& wanted = entry.settings.empty() ? config.settings : entry.settings;
  for (const std::string& setting : wanted) {
    if (!agent.is_privileged) agent.models[setting] = SourcesOf(entry, config, setting);
    const std::string why = WhyNot(config, setting, &agent);
    if (why.empty()) {
      agent.settings.push_back(setting);
      NoteFrames(config, setting, &agent);
    } else {
      agent.missing +=
          fmt::format("{}not in {}: {}", agent.missing.empty() ? "" : "; ", setting, why);
    }
  }
  return agent;
}

}  // namespace

AgentRow RunAgent::row() const {
  AgentRow row;
  row.agent = entry.name;
  row.title = entry.title;
  row.frames_trained = frames_trained;
  if (!settings.empty() && is_privileged) row.note = "privileged";
  const bool has_oracle =
      std::any_of(entry.models.begin(), entry.models.end(), [](const auto& model) {
        return model.second == kOracleModel;
      });
  if (!settings.empty() && has_oracle) row.note = "oracle";
  for (const SemanticFunction function : entry.oracle_functions) {
    row.note += (row.note.empty() ? "oracle " : ", ") + std::string(sim::NameOf(function));
  }
  if (!missing.empty()) row.note += (row.note.empty() ? "" : "; ") + missing;
  return row;
}

std::vector<RunAgent> FindAgents(const RunConfig& config) {
  RequireKnownWeights(config);
  std::vector<RunAgent> agents;
  for (const AgentEntry& entry : config.agents) {
    agents.push_back(FindAgent(config, entry));
  }
  return agents;
}

std::vector<std::string> MissingAgents(std::span<const RunAgent> agents) {
  std::vector<std::string> missing;
  for (const RunAgent& agent : agents) {
    if (!agent.missing.empty()) missing.push_back(agent.entry.name + ": " + agent.missing);
  }
  return missing;
}

void RequireSome(std::span<const RunAgent> agents) {
  for (const RunAgent& agent : agents) {
    if (!agent.damage.empty()) throw sim::Error(agent.damage);
  }
  const bool can_run = std::any_of(agents.begin(), agents.end(), [](const RunAgent& agent) {
    return !agent.settings.empty();
  });
  if (can_run) return;
  throw sim::Error(fmt::format("no agent can run: {}", fmt::join(MissingAgents(agents), "; ")));
}

void RequireAll(std::span<const RunAgent> agents) {
  const std::vector<std::string> missing = MissingAgents(agents);
  if (missing.empty()) return;
  throw sim::Error(fmt::format("not all agents can run: {}", fmt::join(missing, "; ")));
}

std::optional<std::map<std::string, std::string>> SourceHashes(std::span<const RunAgent> agents) {
  std::map<std::string, std::string> hashes;
  for (const RunAgent& agent : agents) {
    if (!agent.source.empty()) hashes[agent.entry.name] = agent.source;
  }
  if (hashes.empty()) return std::nullopt;
  return hashes;
}

void RequireSameSources(const std::optional<Fingerprints>& saved,
                        std::span<const RunAgent> agents) {
  if (!saved || !saved->sources) return;
  for (const RunAgent& agent : agents) {
    const auto before = saved->sources->find(agent.entry.name);
    if (before == saved->sources->end() || agent.source.empty()) continue;
    if (before->second == agent.source) continue;
    throw sim::Error(fmt::format(
        "the code of agent '{}' has changed since these results were played; give --out another "
        "folder, or delete this one",
        agent.entry.name));
  }
}

Task TaskOf(const RunConfig& config, const std::string& setting, Condition condition, bool sees) {
  Task task;
  task.body = config.body;
  const agent::Rig rig = RigOf(config, setting);
  task.panorama = rig.panorama;
  task.color = sees && rig.has_color;
  task.depth = sees && rig.has_depth;
  if (sees) task.sensors = SensorsOf(config, setting);
  if (sees) task.goal_camera = config.goal;
  task.noise = condition == Condition::kNoNoise ? sim::NoiseMode::kNone : config.noise;
  task.sensor_noise = sim::NamedSensorNoise(config.sensor_noise.value_or("none"));
  task.success = {config.success_distance, condition == Condition::kNoStop};
  task.max_steps = config.max_steps;
  return task;
}

std::unique_ptr<agent::BatchAgent> Build(const RunAgent& agent, const RunConfig& config,
                                         const std::string& setting,
                                         std::span<const GroundTruth* const> truths) {
  if (agent.is_privileged) {
    const auto parameters = sim::ParseYaml(agent.parameters, "parameters of " + agent.entry.name);
    std::vector<std::unique_ptr<PrivilegedAgent>> agents;
    for (std::size_t i = 0; i < truths.size(); ++i) {
      agents.push_back(MakePrivilegedAgent(agent.entry.agent, parameters));
    }
    return std::make_unique<PrivilegedLanes>(std::move(agents), truths);
  }
  return agent.maker(
      ContextsOf(agent.entry, agent.models.at(setting), RigOf(config, setting), truths));
}

}  // namespace bulletnav::bench
