// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/play/ground_truth.h"
#include "sim/base/action.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {

/// An agent that acts on the ground truth instead of observations: a ceiling for tables, not a
/// competitor. An agent X has `static constexpr std::string_view kName`, a nested struct `Config`
/// and a constructor X(const Config&); its file in benchmark/privileged/ ends in
///   const PrivilegedRegistration<X> registration;
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

/// Names of all registered privileged agents, in alphabetical order.
std::vector<std::string> PrivilegedAgentNames();

/// Null if there is no privileged agent of this name. Throws FileError for a bad config.
std::unique_ptr<PrivilegedAgent> MakePrivilegedAgent(
    std::string_view name, const std::optional<sim::YamlNode>& config = {});

/// Its config block with every default spelled out, as YAML text; empty if there is no privileged
/// agent of this name.
std::string ResolvePrivilegedConfig(std::string_view name,
                                    const std::optional<sim::YamlNode>& config);

namespace internal {

struct PrivilegedType {
  std::function<std::unique_ptr<PrivilegedAgent>(const std::optional<sim::YamlNode>&)> make;
  std::function<std::string(const std::optional<sim::YamlNode>&)> resolve;
};

/// Throws Error if the name is taken.
void RegisterPrivileged(std::string_view name, const PrivilegedType& type);

}  // namespace internal

/// Makes privileged agent A known by its name.
template <class A>
class PrivilegedRegistration {
 public:
  PrivilegedRegistration() {
    const auto make = [](const std::optional<sim::YamlNode>& yaml) {
      return std::make_unique<A>(sim::ReadBlock<typename A::Config>(yaml));
    };
    const auto resolve = [](const std::optional<sim::YamlNode>& yaml) {
      return sim::ToYaml(sim::ReadBlock<typename A::Config>(yaml));
    };
    internal::RegisterPrivileged(A::kName, {make, resolve});
  }
};

}  // namespace bulletnav::bench
