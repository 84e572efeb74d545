// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agent/agent.h"
#include "agent/batch_agent.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {

/// Builds an agent, already configured, with one lane a context. Throws Error if the agent cannot
/// work with the contexts. May be called from several threads.
using AgentMaker = std::function<std::unique_ptr<BatchAgent>(std::span<const AgentContext>)>;

/// Names of all registered agents, in alphabetical order.
std::vector<std::string> AgentNames();

/// The maker of a registered agent with its config block; absent or empty: defaults. Throws Error
/// for an unknown name, listing the known ones, and FileError at file:line:column for a bad config.
AgentMaker ConfigureAgent(std::string_view name, const std::optional<sim::YamlNode>& config = {});

/// The same with a name that stands in a file; an unknown one is an error at its place.
AgentMaker ConfigureAgent(const sim::YamlNode& name, const std::optional<sim::YamlNode>& config);

/// The config block of a registered agent with every default spelled out, as YAML text. Throws like
/// ConfigureAgent.
std::string ResolveConfig(std::string_view name, const std::optional<sim::YamlNode>& config);

/// The models that a registered agent can be given, on a body with this rig. Throws Error for an
/// unknown name.
std::vector<ModelSlot> ModelSlotsOf(std::string_view name, const Rig& rig);

namespace internal {

/// What a registration knows of its agent's type.
struct AgentType {
  std::function<std::vector<ModelSlot>(const Rig&)> slots;
  std::function<AgentMaker(const std::optional<sim::YamlNode>&)> configure;
  std::function<std::string(const std::optional<sim::YamlNode>&)> resolve;
};

/// Throws Error if the name is taken.
void Register(std::string_view name, const AgentType& type);

template <class A>
std::unique_ptr<BatchAgent> MakeLanes(const typename A::Config& config,
                                      std::span<const AgentContext> contexts) {
  if constexpr (std::derived_from<A, BatchAgent>) {
    return std::make_unique<A>(config, contexts);
  } else {
    std::vector<std::unique_ptr<Agent>> agents;
    for (const AgentContext& context : contexts) {
      agents.push_back(std::make_unique<A>(config, context));
    }
    std::vector<std::shared_ptr<EncodesTogether>> shared;
    if (contexts.size() > 1) shared = contexts.front().models.All<EncodesTogether>();
    return std::make_unique<LaneAgents>(std::move(agents), std::move(shared));
  }
}

template <class A>
std::vector<ModelSlot> SlotsOf(const Rig& rig) {
  if constexpr (requires { A::ModelSlots(rig); }) return A::ModelSlots(rig);
  return {};
}

}  // namespace internal

/// Makes agent A known by its name. One constant of this type at the end of A's file does it.
template <class A>
class AgentRegistration {
 public:
  AgentRegistration() {
    using Config = typename A::Config;
    const auto configure = [](const std::optional<sim::YamlNode>& yaml) -> AgentMaker {
      return [config = sim::ReadBlock<Config>(yaml)](std::span<const AgentContext> contexts) {
        return internal::MakeLanes<A>(config, contexts);
      };
    };
    const auto resolve = [](const std::optional<sim::YamlNode>& yaml) {
      return sim::ToYaml(sim::ReadBlock<Config>(yaml));
    };
    internal::Register(A::kName, {internal::SlotsOf<A>, configure, resolve});
  }
};

}  // namespace bulletnav::agent
