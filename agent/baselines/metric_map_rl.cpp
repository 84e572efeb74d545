// SPDX-License-Identifier: MIT
#include "agent/policy/policy_agent.h"
#include "agent/registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// A network that sees panorama, goal and crops of a metric map made by depth, and learns by
/// reward. Sources: Neural Topological SLAM, section 5.1 "Metric Spatial Map + RL"; Chen, Gupta and
/// Gupta, "Learning exploration policies for navigation", 2019.
class MetricMapRl final : public PolicyAgent {
 public:
  static constexpr std::string_view kName = "metric_map_rl";
  struct Config : PolicyAgent::Config {
    Config() : PolicyAgent::Config(kAfterReward) {}
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) {
    if (!rig.has_depth) return {};  // there can be no weights; the constructor says so
    return {NeededSlot<PolicyModel>(kPolicy, std::string(kName))};
  }

  MetricMapRl(const Config& config, const AgentContext& context)
      : PolicyAgent(config, PolicyOf(context), context.rig) {}

 private:
  static std::shared_ptr<PolicyModel> PolicyOf(const AgentContext& context) {
    if (!context.rig.has_depth) {
      throw sim::Error("metric_map_rl makes its map by depth; play it in the setting rgbd");
    }
    auto policy = context.models.Need<PolicyModel>(kPolicy);
    if (policy->sees_map()) return policy;
    throw sim::Error(
        "metric_map_rl needs the weights of a policy that is shown a map; these are of one that is "
        "not, which target_driven_rl takes: name others with models: {policy: FILE}");
  }
};

const AgentRegistration<MetricMapRl> registration;

}  // namespace
}  // namespace bulletnav::agent
