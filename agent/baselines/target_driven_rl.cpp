// SPDX-License-Identifier: MIT
#include "agent/policy/policy_agent.h"
#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

/// A siamese network and a GRU that learn by reward.
/// Source: Neural Topological SLAM, section 5.1.
class TargetDrivenRl final : public PolicyAgent {
 public:
  static constexpr std::string_view kName = "target_driven_rl";
  struct Config : PolicyAgent::Config {
    Config() : PolicyAgent::Config(kAfterReward) {}
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& /*rig*/) {
    return {NeededSlot<PolicyModel>(kPolicy, std::string(kName))};
  }

  using PolicyAgent::PolicyAgent;
};

const AgentRegistration<TargetDrivenRl> registration;

}  // namespace
}  // namespace bulletnav::agent
