// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_agents.h"

#include <algorithm>
#include <array>
#include <exception>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "agent/perception/model_file.h"
#include "benchmark/base/file_hash.h"
#include "benchmark/privileged/mixed_semantic_model.h"
#include "benchmark/privileged/oracle_goal_estimator.h"
#include "benchmark/privileged/oracle_semantic_model.h"
#include "sim/base/check.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Privileged agents behind the interface of the others: they see the truth instead of what the
/// observations hold.
class PrivilegedLanes final : public agent::BatchAgent {
 public:
  PrivilegedLanes(std::vector<std::unique_ptr<PrivilegedAgent>> agents,
                  std::span<const GroundTruth* const> truths)
      : agents_(std::move(agents)), truths_(truths.begin(), truths.end()) {
    CHECK_EQ(agents_.size(), truths_.size());
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

constexpr const char* kWithoutTorch = "this program was built without the learned functions";

/// Stand for models in a program that cannot load them.
class UnloadedModel final : public agent::SemanticModel {
 public:
  std::vector<agent::PanoramaCode> Encode(std::span<const agent::Panorama>) override {
    throw sim::Error(kWithoutTorch);
  }
  std::array<float, agent::kDirections> Explorable(const agent::PanoramaCode&) override {
    throw sim::Error(kWithoutTorch);
  }
  std::vector<agent::PairPrediction> Compare(std::span<const agent::PanoramaCode* const>,
                                             const agent::PanoramaCode&) override {
    throw sim::Error(kWithoutTorch);
  }
};

class UnloadedMapper final : public agent::FreeSpaceModel {
 public:
  agent::FreeSpace Predict(const agent::Panorama&) override { throw sim::Error(kWithoutTorch); }
};

Setting SettingOf(const agent::Rig& rig) {
  return rig.has_depth ? Setting::kRgbd : Setting::kRgb;
}

/// Whether an agent that looks at panoramas through some model is given the mapper as well.
bool TakesMapper(const AgentEntry& entry, Setting setting) {
  return setting == Setting::kRgb && entry.semantic_model != SemanticModelKind::kNone;
}

/// As FindWeights; absent if there is no such file.
std::optional<fs::path> FindIfThere(const std::string& weights) {
  if (fs::exists(weights)) return weights;
  fs::path folder = fs::read_symlink("/proc/self/exe");
  while (fs::path(weights).is_relative() && folder.has_relative_path()) {
    folder = folder.parent_path();
    if (fs::exists(folder / weights)) return folder / weights;
  }
  return std::nullopt;
}

/// What an agent needs in a setting, whether it is there or not: by its key in `weights`.
std::map<std::string, std::string> WeightsOf(const AgentEntry& entry, const WeightsSpec& weights,
                                             Setting setting) {
  std::map<std::string, std::string> needed;
  if (TakesMapper(entry, setting)) needed["mapper"] = weights.mapper;
  if (entry.semantic_model == SemanticModelKind::kLearned) {
    needed[std::string(sim::NameOf(setting))] = weights.of(setting);
  }
  return needed;
}

/// The files of those that are there.
std::map<std::string, fs::path> WeightsThere(const AgentEntry& entry, const WeightsSpec& weights,
                                             Setting setting) {
  std::map<std::string, fs::path> there;
  for (const auto& [key, name] : WeightsOf(entry, weights, setting)) {
    if (const auto file = FindIfThere(name)) there[key] = *file;
  }
  return there;
}

/// The functions that an agent asks the ground truth for.
void AddOracles(const AgentEntry& entry, const GroundTruth& truth, agent::AgentContext* context) {
  const auto oracle = std::make_shared<OracleSemanticModel>(truth);
  if (entry.semantic_model == SemanticModelKind::kOracle) {
    context->goal_estimator = std::make_shared<OracleGoalEstimator>(truth);
    context->semantic_model = oracle;
  } else if (!entry.oracle_functions.empty()) {
    context->semantic_model = std::make_shared<MixedSemanticModel>(
        context->semantic_model, oracle,
        std::set<SemanticFunction>(entry.oracle_functions.begin(), entry.oracle_functions.end()));
  }
}

/// The contexts of all lanes; learned models are shared by them.
std::vector<agent::AgentContext> ContextsOf(const RunAgent& agent, const agent::Rig& rig,
                                            std::span<const GroundTruth* const> truths) {
  agent::AgentContext shared;
  shared.rig = rig;
  if (agent.is_learned()) {
    shared.semantic_model =
        agent.loaders.semantic_model(FindWeights(agent.weights.of(SettingOf(rig))), rig);
  }
  if (TakesMapper(agent.entry, SettingOf(rig))) {
    // Not every agent needs it; those that do say so.
    if (const auto file = FindIfThere(agent.weights.mapper)) {
      shared.mapper = agent.loaders.mapper(*file, rig);
    }
  }
  std::vector<agent::AgentContext> contexts(truths.size(), shared);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    AddOracles(agent.entry, *truths[i], &contexts[i]);
  }
  return contexts;
}

/// How many panoramas the functions of these weights were trained on, counted as often as they were
/// shown, by what the trainer noted in the file; absent if it did not.
std::optional<std::int64_t> FramesTrained(const fs::path& weights) {
  const agent::TensorFile file = agent::ReadTensorFile(weights);
  const auto step = file.metadata.find("step");
  const auto training = file.metadata.find("training");
  if (step == file.metadata.end() || training == file.metadata.end()) return std::nullopt;
  try {
    const YAML::Node plan = YAML::Load(training->second);
    return std::stoll(step->second) * plan["scenes"].as<std::int64_t>() *
           plan["panoramas"].as<std::int64_t>();
  } catch (const std::exception&) {
    return std::nullopt;  // of another program
  }
}

/// Whether results that were saved with this config are of the weights that are there now.
bool IsOfTheseWeights(const RunConfig& config, const std::string& key, const fs::path& weights) {
  if (!config.fingerprints) return true;
  const auto saved = config.fingerprints->weights.find(key);
  return saved == config.fingerprints->weights.end() || saved->second == FileHash(weights);
}

/// Those of the semantic functions and of the mapper, where it is used.
void NoteFrames(const RunConfig& config, Setting setting, RunAgent* agent) {
  std::int64_t sum = 0;
  for (const auto& [name, file] : WeightsThere(agent->entry, agent->weights, setting)) {
    const auto frames = FramesTrained(file);
    if (!frames || !IsOfTheseWeights(config, name, file)) return;
    sum += *frames;
  }
  agent->frames_trained[std::string(sim::NameOf(setting))] = sum;
}

bool HasWeights(const RunAgent& agent, Setting setting) {
  return WeightsThere(agent.entry, agent.weights, setting).size() ==
         WeightsOf(agent.entry, agent.weights, setting).size();
}

/// Why the agent cannot be built; empty if it can. Weights that are there but cannot be used also
/// go into `damage`.
std::string WhyNot(const RunAgent& agent, const agent::Rig& rig, std::string* damage) {
  const GroundTruth nowhere;
  const std::array<const GroundTruth*, 1> truths = {&nowhere};
  try {
    Build(agent, rig, truths);
  } catch (const sim::FileError& e) {
    if (HasWeights(agent, SettingOf(rig))) *damage = e.what();
    return e.what();
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "";
}

RunAgent FindAgent(const RunConfig& config, const AgentEntry& entry, const ModelLoaders& loaders) {
  RunAgent agent;
  agent.entry = entry;
  agent.weights = config.weights;
  agent.loaders = loaders;
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
  for (const Setting setting : wanted) {
    const std::string why = WhyNot(agent, RigOf(config, setting), &agent.damage);
    if (why.empty()) {
      agent.settings.push_back(setting);
      if (agent.is_learned()) NoteFrames(config, setting, &agent);
    } else {
      agent.missing += (agent.missing.empty() ? "not in " : "; not in ") +
                       std::string(sim::NameOf(setting)) + ": " + why;
    }
  }
  return agent;
}

}  // namespace

ModelLoaders WeightsCheck() {
  ModelLoaders loaders;
  loaders.semantic_model = [](const fs::path& weights, const agent::Rig& rig) {
    const agent::ModelConfig config = agent::ModelConfigOf(agent::ReadTensorFile(weights), weights);
    agent::RequireRig(rig, config, weights);
    return std::make_shared<UnloadedModel>();
  };
  loaders.mapper = [](const fs::path& weights, const agent::Rig& rig) {
    const agent::MapperConfig config =
        agent::MapperConfigOf(agent::ReadTensorFile(weights), weights);
    agent::RequireRig(rig, config.seeing(), weights);
    return std::make_shared<UnloadedMapper>();
  };
  return loaders;
}

fs::path FindWeights(const std::string& weights) {
  if (const auto file = FindIfThere(weights)) return *file;
  throw sim::FileError(weights, "",
                       "does not exist; train it: ./bulletnav train configs/train/...");
}

std::map<std::string, fs::path> UsedWeights(const RunConfig& config) {
  std::map<std::string, fs::path> used;
  for (const AgentEntry& entry : config.agents) {
    for (const Setting setting : entry.settings.empty() ? config.settings : entry.settings) {
      used.merge(WeightsThere(entry, config.weights, setting));
    }
  }
  return used;
}

bool RunAgent::needs_torch() const {
  return std::any_of(settings.begin(), settings.end(), [&](Setting setting) {
    return is_learned() || (TakesMapper(entry, setting) && FindIfThere(weights.mapper));
  });
}

AgentRow RunAgent::row() const {
  AgentRow row;
  row.agent = entry.name;
  row.title = entry.title;
  row.frames_trained = frames_trained;
  if (!settings.empty() && is_privileged) row.note = "privileged";
  if (!settings.empty() && entry.semantic_model == SemanticModelKind::kOracle) row.note = "oracle";
  for (const SemanticFunction function : entry.oracle_functions) {
    row.note += (row.note.empty() ? "oracle " : ", ") + std::string(sim::NameOf(function));
  }
  if (!missing.empty()) row.note += (row.note.empty() ? "" : "; ") + missing;
  return row;
}

std::vector<RunAgent> FindAgents(const RunConfig& config, const ModelLoaders& loaders) {
  std::vector<RunAgent> agents;
  for (const AgentEntry& entry : config.agents) {
    agents.push_back(FindAgent(config, entry, loaders));
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

agent::Rig RigOf(const RunConfig& config, Setting setting) {
  agent::Rig rig;
  rig.panorama = config.panorama;
  rig.has_color = true;
  rig.has_depth = setting == Setting::kRgbd;
  rig.camera_height = config.body.camera_height;
  return rig;
}

EpisodeRules RulesOf(const RunConfig& config, Setting setting, Condition condition, bool sees) {
  EpisodeRules rules;
  rules.body = config.body;
  rules.panorama = config.panorama;
  rules.color = sees;
  rules.depth = sees && setting == Setting::kRgbd;
  rules.noise = condition == Condition::kNoNoise ? sim::NoiseMode::kNone : config.noise;
  rules.success = {config.success_distance, condition == Condition::kNoStop};
  rules.max_steps = config.max_steps;
  return rules;
}

std::unique_ptr<agent::BatchAgent> Build(const RunAgent& agent, const agent::Rig& rig,
                                         std::span<const GroundTruth* const> truths) {
  if (agent.is_privileged) {
    const auto parameters = sim::ParseYaml(agent.parameters, "parameters of " + agent.entry.name);
    std::vector<std::unique_ptr<PrivilegedAgent>> agents;
    for (std::size_t i = 0; i < truths.size(); ++i) {
      agents.push_back(MakePrivilegedAgent(agent.entry.agent, parameters));
    }
    return std::make_unique<PrivilegedLanes>(std::move(agents), truths);
  }
  return agent.maker(ContextsOf(agent, rig, truths));
}

}  // namespace bulletnav::bench
