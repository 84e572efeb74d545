// SPDX-License-Identifier: MIT
#include "agent/registry.h"

#include <map>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Filled before main by the registrations and only read after that.
std::map<std::string, internal::AgentType, std::less<>>& Registered() {
  static std::map<std::string, internal::AgentType, std::less<>> agents;
  return agents;
}

std::string UnknownName(std::string_view name) {
  std::string known;
  for (const std::string& other : AgentNames()) known += (known.empty() ? "" : ", ") + other;
  return "unknown agent '" + std::string(name) + "'; known are: " + known;
}

const internal::AgentType& FindType(std::string_view name) {
  const auto found = Registered().find(name);
  if (found == Registered().end()) throw sim::Error(UnknownName(name));
  return found->second;
}

}  // namespace

std::vector<std::string> AgentNames() {
  std::vector<std::string> names;
  for (const auto& [name, type] : Registered()) names.push_back(name);
  return names;
}

std::vector<ModelSlot> ModelSlotsOf(std::string_view name, const Rig& rig) {
  return FindType(name).slots(rig);
}

AgentMaker ConfigureAgent(std::string_view name, const std::optional<sim::YamlNode>& config) {
  return FindType(name).configure(config);
}

std::string ResolveConfig(std::string_view name, const std::optional<sim::YamlNode>& config) {
  return FindType(name).resolve(config);
}

AgentMaker ConfigureAgent(const sim::YamlNode& name, const std::optional<sim::YamlNode>& config) {
  const std::string text = name.ToString();
  if (!Registered().contains(text)) name.Fail(UnknownName(text));
  return ConfigureAgent(text, config);
}

void internal::Register(std::string_view name, const AgentType& type) {
  if (!Registered().try_emplace(std::string(name), type).second) {
    throw sim::Error("two agents are called '" + std::string(name) + "'");
  }
}

}  // namespace bulletnav::agent
