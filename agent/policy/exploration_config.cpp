// SPDX-License-Identifier: MIT
#include "agent/policy/exploration_config.h"

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

void ExplorationConfig::Validate() const {
  if (features < 16 || features > 4096 || features % 16 != 0) {
    throw sim::Error("features must be a multiple of 16 from 16 to 4096");
  }
  if (heading_size < 1 || heading_size > 256) {
    throw sim::Error("heading_size must lie between 1 and 256");
  }
}

ExplorationConfig ExplorationConfigOf(const TensorFile& weights,
                                      const std::filesystem::path& file) {
  const auto found = weights.metadata.find(kExplorationKey);
  if (found == weights.metadata.end()) {
    throw sim::FileError(file, "", "does not hold the weights of an exploration policy; train one");
  }
  return sim::LoadYamlText<ExplorationConfig>(found->second, file);
}

}  // namespace bulletnav::agent
