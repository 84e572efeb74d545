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
    Config() {  // of the shipped policies; chosen on goals of the validation houses
      stop_from = 0.4;
      stop_steps = 2;
    }
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& /*rig*/) {
    return {NeededSlot<PolicyModel>(kPolicy, std::string(kName))};
  }

  using PolicyAgent::PolicyAgent;
};

const AgentRegistration<ResnetGruIl> registration;

}  // namespace
}  // namespace bulletnav::agent
