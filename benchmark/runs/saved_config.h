// SPDX-License-Identifier: MIT
#pragma once
#include <yaml-cpp/yaml.h>

namespace bulletnav::bench {

/// Rewrites the config.yaml of results that an earlier version played, where keys have other names
/// or places now. Anything else stays as it is.
void BringUpToDate(YAML::Node config);

}  // namespace bulletnav::bench
