// SPDX-License-Identifier: MIT
#include "benchmark/privileged/privileged_agent.h"

#include "benchmark/privileged/shortest_path.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

ShortestPathAgent::Config ReadConfig(const std::optional<sim::YamlNode>& config) {
  ShortestPathAgent::Config values;
  if (config && !config->yaml().IsNull()) sim::YamlReader::Read(*config, values);
  return values;
}

}  // namespace

std::vector<std::string> PrivilegedAgentNames() {
  return {std::string(ShortestPathAgent::kName)};
}

std::unique_ptr<PrivilegedAgent> MakePrivilegedAgent(std::string_view name,
                                                     const std::optional<sim::YamlNode>& config) {
  if (name != ShortestPathAgent::kName) return nullptr;
  return std::make_unique<ShortestPathAgent>(ReadConfig(config));
}

std::string ResolvePrivilegedConfig(std::string_view name,
                                    const std::optional<sim::YamlNode>& config) {
  if (name != ShortestPathAgent::kName) return "";
  return sim::ToYaml(ReadConfig(config));
}

}  // namespace bulletnav::bench
