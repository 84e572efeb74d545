// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_config.h"

#include <algorithm>
#include <set>

#include <fmt/ranges.h>

#include "agent/registry.h"
#include "benchmark/privileged/privileged_agent.h"
#include "benchmark/runs/published.h"
#include "benchmark/runs/saved_config.h"
#include "sim/config/override.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::bench {
namespace {

using sim::Error;
using sim::KeyError;
using sim::YamlNode;

constexpr const char* kColorSetting = "rgb";
constexpr const char* kDepthSetting = "rgbd";

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class T>
void RequireDistinct(const std::vector<T>& values, const char* key, bool may_be_empty) {
  if (values.empty() && !may_be_empty) {
    throw KeyError(key, std::string("'") + key + "' is empty");
  }
  if (std::set<T>(values.begin(), values.end()).size() != values.size()) {
    throw KeyError(key, std::string("'") + key + "' names a value twice");
  }
}

std::vector<std::string> KnownAgents() {
  std::vector<std::string> names = agent::AgentNames();
  for (std::string& name : PrivilegedAgentNames()) names.push_back(std::move(name));
  return names;
}

[[noreturn]] void FailForUnknown(const YamlNode& name) {
  const std::string text = name.ToString();
  const std::vector<std::string> known = KnownAgents();
  const std::string nearest = sim::NearestWord(text, known);
  std::string what = "unknown agent '" + text + "'";
  if (!nearest.empty()) what += "; did you mean '" + nearest + "'?";
  std::string list;
  for (const std::string& other : known) list += (list.empty() ? "" : ", ") + other;
  name.Fail(what + (nearest.empty() ? ". Known are: " : " Known are: ") + list);
}

std::vector<std::string> KnownSettings(const RunConfig& config) {
  std::vector<std::string> known;
  if (!config.goal) known = {kColorSetting, kDepthSetting};
  for (const auto& [name, sensors] : config.sensors) known.push_back(name);
  return known;
}

/// Complains of settings that nothing is known of. `map`: where the list stands, if it does.
void RequireKnown(const YamlNode& map, const std::vector<std::string>& settings,
                  const RunConfig& config) {
  const std::vector<std::string> known = KnownSettings(config);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (Contains(known, settings[i])) continue;
    const YamlNode list = map.Child(map.yaml()["settings"]);
    list.Child(list.yaml()[i])
        .Fail(fmt::format("unknown setting '{}'; known are: {}; 'sensors' can define more",
                          settings[i], fmt::join(known, ", ")));
  }
}

/// Spells out what fills the slots that the agent has on some body.
void ResolveModels(const YamlNode& node, const RunConfig& config, AgentEntry* entry) {
  std::map<std::string, std::string> models;
  for (const std::string& setting : KnownSettings(config)) {
    for (const agent::ModelSlot& slot : agent::ModelSlotsOf(entry->agent, RigOf(config, setting))) {
      models.emplace(slot.name, kLearnedModel);
    }
  }
  for (const auto& [slot, model] : entry->models) {
    const auto found = models.find(slot);
    if (found == models.end()) {
      node.FailAt("models", entry->agent + " takes no model called '" + slot + "'");
    }
    found->second = model;
  }
  entry->models = std::move(models);
}

/// Fills in what is left to defaults; `node` is where the entry stands.
void Resolve(const YamlNode& node, const RunConfig& config, AgentEntry* entry) {
  if (entry->name.empty()) entry->name = entry->agent;
  std::string parameters;
  if (Contains(PrivilegedAgentNames(), entry->agent)) {
    parameters = ResolvePrivilegedConfig(entry->agent, entry->parameters);
  } else if (Contains(agent::AgentNames(), entry->agent)) {
    parameters = agent::ResolveConfig(entry->agent, entry->parameters);
    ResolveModels(node, config, entry);
  } else if (IsPlannedAgent(entry->agent)) {
    return;
  } else {
    FailForUnknown(node.Child(node.yaml()["agent"]));
  }
  entry->parameters.emplace(sim::ParseYaml(parameters, "parameters of " + entry->name));
}

/// The same, for agents that may have changed or gone since they played.
void ResolveIfKnown(const YamlNode& node, const RunConfig& config, AgentEntry* entry) {
  try {
    Resolve(node, config, entry);
  } catch (const Error&) {
    entry->trouble = "this version of the program has no such agent, or one with other parameters";
  }
}

RunConfig Parse(const YamlNode& root, const std::filesystem::path& file,
                void (*resolve)(const YamlNode& node, const RunConfig& config, AgentEntry* entry)) {
  RunConfig config;
  sim::YamlReader::Read(root, config);
  if (config.name.empty()) config.name = file.stem().string();
  RequireKnown(root, config.settings, config);
  const YamlNode agents = root.Child(root.yaml()["agents"]);
  std::set<std::string> names;
  for (std::size_t i = 0; i < config.agents.size(); ++i) {
    const YamlNode node = agents.Child(agents.yaml()[i]);
    RequireKnown(node, config.agents[i].settings, config);
    resolve(node, config, &config.agents[i]);
    if (!names.insert(config.agents[i].name).second) {
      node.Fail("two agents are called '" + config.agents[i].name + "'; give one a 'name'");
    }
  }
  return config;
}

}  // namespace

namespace {

/// What a setting of the config's own must be like.
void RequireUsable(const std::string& setting, const sim::SensorSet& sensors, bool has_goal) {
  if (setting == kColorSetting || setting == kDepthSetting) {
    throw KeyError("sensors", "'" + setting + "' is there already; give the set another name");
  }
  if (has_goal && sensors.panorama()) {
    throw KeyError("sensors", "the set '" + setting +
                                  "' has a panorama, but goals are flat pictures, as 'goal' says; "
                                  "give it a sensor of type pinhole");
  }
  if (!has_goal && !sensors.panorama()) {
    throw KeyError("sensors", "the set '" + setting +
                                  "' needs a sensor 'panorama' of type panorama: goals are "
                                  "pictures of it, unless 'goal' gives another camera");
  }
}

void RequireNoPanoramas(const std::vector<std::string>& settings) {
  for (const char* name : {kColorSetting, kDepthSetting}) {
    if (!Contains(settings, name)) continue;
    throw KeyError("settings", std::string("'") + name +
                                   "' shows panoramas, but goals are flat pictures, as 'goal' "
                                   "says; name sets of 'sensors'");
  }
}

}  // namespace

void AgentEntry::Validate() const {
  RequireDistinct(settings, "settings", true);
  if (lanes < 1 || lanes > 4096) throw KeyError("lanes", "lanes must lie between 1 and 4096");
  RequireDistinct(oracle_functions, "oracle_functions", true);
  const auto semantic = models.find("semantic_model");
  const bool has_weights = semantic == models.end() ||
                           (semantic->second != kOracleModel && semantic->second != kNoModel);
  if (!oracle_functions.empty() && !has_weights) {
    throw KeyError("oracle_functions",
                   "oracle_functions replace some of a learned semantic_model, which is not there");
  }
}

void RunConfig::Validate() const {
  RequireDistinct(settings, "settings", false);
  RequireDistinct(conditions, "conditions", false);
  RequireDistinct(seeds, "seeds", false);
  if (name.find('/') != std::string::npos || name == "." || name == "..") {
    throw KeyError("name", "'name' must be a word, not a path");
  }
  if (agents.empty()) throw KeyError("agents", "'agents' is empty; name at least one");
  if (!(success_distance > 0.0)) {
    throw KeyError("success_distance", "success_distance must be positive");
  }
  if (max_steps < 1 || max_steps > 1'000'000) {
    throw KeyError("max_steps", "max_steps must lie between 1 and 1000000");
  }
  panorama.Validate();
  sim::RequireSensorNoise(sensor_noise.value_or("none"));
  for (const auto& [setting, set] : sensors) RequireUsable(setting, set, goal.has_value());
  if (goal) {
    goal->Validate();
    RequireNoPanoramas(settings);
    for (const AgentEntry& entry : agents) RequireNoPanoramas(entry.settings);
  }
  if (episodes.draw) generator().Validate();
}

GeneratorSpec RunConfig::generator() const {
  const DrawSpec& draw = episodes.draw.value();
  GeneratorSpec spec;
  spec.scenes = draw.scenes;
  spec.houses = draw.houses;
  spec.import = import;
  spec.counts = draw.counts;
  spec.sequential_goals = draw.sequential_goals;
  spec.seed = draw.seed;
  spec.body = body;
  spec.navmesh = navmesh;
  spec.out = episodes.file;
  return spec;
}

std::string RunConfig::weights_file(const std::string& key) const {
  const auto named = weights.find(key);
  return named == weights.end() ? "assets/weights/" + key + ".safetensors" : named->second;
}

sim::SensorSet SensorsOf(const RunConfig& config, const std::string& setting) {
  const auto own = config.sensors.find(setting);
  if (own != config.sensors.end()) return own->second;
  return sim::SensorSet::Usual(config.panorama, true, setting == kDepthSetting);
}

agent::Rig RigOf(const RunConfig& config, const std::string& setting) {
  const sim::SensorSet sensors = SensorsOf(config, setting);
  agent::Rig rig;
  rig.panorama = sensors.panorama().value_or(config.panorama);
  rig.arrays = sensors.arrays();
  if (config.goal) {
    rig.arrays.push_back({kGoalPicture,
                          {config.goal->rows, config.goal->cols, 3},
                          sim::Element::kUint8,
                          "display value"});
  }
  rig.has_color = rig.FindArray(sim::Observation::kColor) != nullptr;
  rig.has_depth = rig.FindArray(sim::Observation::kDepth) != nullptr;
  rig.camera_height = config.body.camera_height;
  rig.body_radius = config.body.radius;
  rig.body_height = config.body.height;
  return rig;
}

bool IsPlannedAgent(const std::string& agent) {
  return !PublishedTitle(agent).empty();
}

RunConfig LoadRunConfig(const std::filesystem::path& file, std::span<const std::string> overrides) {
  const YamlNode root = sim::ParseYaml(sim::ReadYamlFile(file), file);
  return Parse(sim::WithOverrides(root, file, overrides), file, Resolve);
}

RunConfig LoadSavedRunConfig(const std::filesystem::path& file) {
  const YamlNode root = sim::ParseYaml(sim::ReadYamlFile(file), file);
  BringUpToDate(root.yaml());
  return Parse(root, file, ResolveIfKnown);
}

RunConfig ParseRunConfig(const std::string& text, const std::filesystem::path& file) {
  return Parse(sim::ParseYaml(text, file), file, Resolve);
}

}  // namespace bulletnav::bench
