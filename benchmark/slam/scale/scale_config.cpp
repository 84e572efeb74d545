// SPDX-License-Identifier: MIT
#include "benchmark/slam/scale/scale_config.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/config/override.h"

namespace bulletnav::bench {

void ScaleConfig::Validate() const {
  if (actions < 1 || other_actions < 1 || query_every < 1) {
    throw sim::Error("expected actions, other_actions and query_every of at least 1");
  }
  if (queries == others) {
    throw sim::KeyError("others", "'others' must be another split than 'queries'");
  }
  if (!(apart_m > 0.0)) throw sim::KeyError("apart_m", "apart_m must be positive");
  if (sizes.empty()) throw sim::KeyError("sizes", "'sizes' has no number");
  if (!std::is_sorted(sizes.begin(), sizes.end())) {
    throw sim::KeyError("sizes", "'sizes' must rise");
  }
  if (sizes.front() <= actions) {
    throw sim::KeyError("sizes",
                        "'sizes' must be above 'actions': the frames of a drive and others");
  }
}

ScaleConfig LoadScaleConfig(const std::filesystem::path& file,
                            std::span<const std::string> overrides) {
  const sim::YamlNode root = sim::ReadWithOverrides(file, overrides);
  ScaleConfig config;
  sim::YamlReader::Read(root, config);
  if (config.name.empty()) config.name = file.stem().string();
  return config;
}

}  // namespace bulletnav::bench
