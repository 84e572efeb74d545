// SPDX-License-Identifier: MIT
#include "agent/policy/exploration_config.h"

#include "agent/models/config_in_weights.h"
#include "sim/base/error.h"

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
  return ConfigInWeights<ExplorationConfig>(weights, kExplorationKey, file,
                                            "an exploration policy; train one");
}

}  // namespace bulletnav::agent
