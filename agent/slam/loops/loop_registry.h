// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/slam/loops/loop_detector.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {

/// Builds a detector, already configured, for one drive. May be called from several threads.
using LoopDetectorMaker = std::function<std::unique_ptr<LoopDetector>(const LoopContext&)>;

/// Names of all registered detectors, in alphabetical order.
std::vector<std::string> LoopDetectorNames();

/// The maker of a registered detector with its config block; absent or empty: defaults. Throws
/// FileError at the name's place for an unknown one, listing the known ones, and at
/// file:line:column for a bad config.
LoopDetectorMaker ConfigureLoopDetector(const sim::YamlNode& name,
                                        const std::optional<sim::YamlNode>& config);

/// The config block of a detector with every default spelled out, as YAML text. Throws likewise.
std::string ResolveLoopConfig(const sim::YamlNode& name,
                              const std::optional<sim::YamlNode>& config);

namespace internal {

struct LoopDetectorType {
  std::function<LoopDetectorMaker(const std::optional<sim::YamlNode>&)> configure;
  std::function<std::string(const std::optional<sim::YamlNode>&)> resolve;
};

/// Throws Error if the name is taken.
void RegisterLoopDetector(std::string_view name, const LoopDetectorType& type);

}  // namespace internal

/// Makes detector D known by its name. One constant of this type at the end of D's file does it.
template <class D>
class LoopDetectorRegistration {
 public:
  LoopDetectorRegistration() {
    using Config = typename D::Config;
    const auto configure = [](const std::optional<sim::YamlNode>& yaml) -> LoopDetectorMaker {
      return [config = sim::ReadBlock<Config>(yaml)](const LoopContext& context) {
        return std::make_unique<D>(config, context);
      };
    };
    const auto resolve = [](const std::optional<sim::YamlNode>& yaml) {
      return sim::ToYaml(sim::ReadBlock<Config>(yaml));
    };
    internal::RegisterLoopDetector(D::kName, {configure, resolve});
  }
};

}  // namespace bulletnav::agent
