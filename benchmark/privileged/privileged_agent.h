// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/play/ground_truth.h"
#include "sim/base/action.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// An agent that acts on the ground truth instead of observations: a ceiling for tables, not a
/// competitor.
class PrivilegedAgent {
 public:
  PrivilegedAgent() = default;
  virtual ~PrivilegedAgent() = default;
  PrivilegedAgent(const PrivilegedAgent&) = delete;
  PrivilegedAgent& operator=(const PrivilegedAgent&) = delete;
  PrivilegedAgent(PrivilegedAgent&&) = delete;
  PrivilegedAgent& operator=(PrivilegedAgent&&) = delete;

  /// Starts an episode, or a next goal.
  virtual void Reset(const GroundTruth& truth) = 0;
  virtual sim::Action Act(const GroundTruth& truth) = 0;
};

std::vector<std::string> PrivilegedAgentNames();

/// Null if there is no privileged agent of this name. Throws FileError for a bad config.
std::unique_ptr<PrivilegedAgent> MakePrivilegedAgent(
    std::string_view name, const std::optional<sim::YamlNode>& config = {});

/// Its config block with every default spelled out, as YAML text; empty if there is no privileged
/// agent of this name.
std::string ResolvePrivilegedConfig(std::string_view name,
                                    const std::optional<sim::YamlNode>& config);

}  // namespace bulletnav::bench
