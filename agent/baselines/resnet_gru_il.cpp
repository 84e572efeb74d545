// SPDX-License-Identifier: MIT
#include "agent/policy/policy_agent.h"
#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

/// A ResNet and a GRU that imitate the shortest path.
/// Source: Neural Topological SLAM, section 5.1.
class ResnetGruIl final : public PolicyAgent {
 public:
  static constexpr std::string_view kName = "resnet_gru_il";
  struct Config : PolicyAgent::Config {
    Config() : PolicyAgent::Config(kAfterImitation) {}
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& /*rig*/) {
    return {NeededSlot<PolicyModel>(kPolicy, std::string(kName))};
  }

  using PolicyAgent::PolicyAgent;
};

const AgentRegistration<ResnetGruIl> registration;

}  // namespace
}  // namespace bulletnav::agent
