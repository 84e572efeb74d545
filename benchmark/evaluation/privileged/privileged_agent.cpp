// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/privileged/privileged_agent.h"

#include "benchmark/evaluation/privileged/shortest_path.h"

namespace bulletnav::bench {

std::vector<std::string> PrivilegedAgentNames() {
  return {std::string(ShortestPathAgent::kName)};
}

std::unique_ptr<PrivilegedAgent> MakePrivilegedAgent(std::string_view name,
                                                     const std::optional<sim::YamlNode>& config) {
  if (name != ShortestPathAgent::kName) return nullptr;
  ShortestPathAgent::Config values;
  if (config && !config->yaml().IsNull()) sim::YamlReader::Read(*config, values);
  return std::make_unique<ShortestPathAgent>(values);
}

}  // namespace bulletnav::bench
