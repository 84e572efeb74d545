// SPDX-License-Identifier: MIT
#include "benchmark/cli/shipped_config.h"

#include <fmt/core.h>

#include "benchmark/base/shipped_file.h"

namespace bulletnav::bench {

std::filesystem::path ShippedConfig(const std::filesystem::path& config) {
  if (config.empty() || *config.begin() != "configs") return config;
  const auto found = FindShipped(config);
  if (!found || *found == config) return config;
  fmt::print(stderr, "note: {} is not here; {} is taken\n", config.string(), found->string());
  return *found;
}

}  // namespace bulletnav::bench
