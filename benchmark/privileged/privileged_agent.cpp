// SPDX-License-Identifier: MIT
#include "benchmark/privileged/privileged_agent.h"

#include <map>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// Filled before main by the registrations and only read after that.
std::map<std::string, internal::PrivilegedType, std::less<>>& Registered() {
  static std::map<std::string, internal::PrivilegedType, std::less<>> agents;
  return agents;
}

}  // namespace

std::vector<std::string> PrivilegedAgentNames() {
  std::vector<std::string> names;
  for (const auto& [name, type] : Registered()) names.push_back(name);
  return names;
}

std::unique_ptr<PrivilegedAgent> MakePrivilegedAgent(std::string_view name,
                                                     const std::optional<sim::YamlNode>& config) {
  const auto found = Registered().find(name);
  return found == Registered().end() ? nullptr : found->second.make(config);
}

std::string ResolvePrivilegedConfig(std::string_view name,
                                    const std::optional<sim::YamlNode>& config) {
  const auto found = Registered().find(name);
  return found == Registered().end() ? "" : found->second.resolve(config);
}

void internal::RegisterPrivileged(std::string_view name, const PrivilegedType& type) {
  if (!Registered().try_emplace(std::string(name), type).second) {
    throw sim::Error("two privileged agents are called '" + std::string(name) + "'");
  }
}

}  // namespace bulletnav::bench
