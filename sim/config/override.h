// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// A config with values set from a command line, each as "KEY=VALUE": KEY is a path of keys and
/// places in lists ("episodes.draw.seed", "agents.0.lanes"), VALUE is YAML ("5", "[rgb, rgbd]",
/// "{a: 1}"; nothing after "=" is an empty text). Keys that are not there are added, for the reader
/// to accept or refuse; its complaints then name the file and what was set. Changes `root`.
/// Throws Error, naming KEY: no "=", an empty key, a place that the list lacks, a key below a
/// single value, a VALUE that is no YAML.
YamlNode WithOverrides(const YamlNode& root, const std::filesystem::path& file,
                       std::span<const std::string> overrides);

/// A config file with values set so. Throws FileError if it cannot be read, and as WithOverrides.
YamlNode ReadWithOverrides(const std::filesystem::path& file,
                           std::span<const std::string> overrides);

}  // namespace bulletnav::sim
