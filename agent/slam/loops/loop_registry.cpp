// SPDX-License-Identifier: MIT
#include "agent/slam/loops/loop_registry.h"

#include <map>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

using internal::LoopDetectorType;

/// Filled before main by the registrations and only read after that.
std::map<std::string, LoopDetectorType, std::less<>>& Registered() {
  static std::map<std::string, LoopDetectorType, std::less<>> detectors;
  return detectors;
}

const LoopDetectorType& FindType(const sim::YamlNode& name) {
  const std::string text = name.ToString();
  const auto found = Registered().find(text);
  if (found != Registered().end()) return found->second;
  std::string known;
  for (const std::string& other : LoopDetectorNames()) {
    known += (known.empty() ? "" : ", ") + other;
  }
  name.Fail("there is no loop detector '" + text + "' in this version; there are: " + known);
}

}  // namespace

std::vector<std::string> LoopDetectorNames() {
  std::vector<std::string> names;
  for (const auto& [name, type] : Registered()) names.push_back(name);
  return names;
}

LoopDetectorMaker ConfigureLoopDetector(const sim::YamlNode& name,
                                        const std::optional<sim::YamlNode>& config) {
  return FindType(name).configure(config);
}

std::string ResolveLoopConfig(const sim::YamlNode& name,
                              const std::optional<sim::YamlNode>& config) {
  return FindType(name).resolve(config);
}

void internal::RegisterLoopDetector(std::string_view name, const LoopDetectorType& type) {
  if (!Registered().try_emplace(std::string(name), type).second) {
    throw sim::Error("two loop detectors are called '" + std::string(name) + "'");
  }
}

}  // namespace bulletnav::agent
