// SPDX-License-Identifier: MIT
#include <optional>
#include <vector>

#include "agent/metric_map/metric_map_agent.h"
#include "agent/models/usual_slots.h"
#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

/// Maps with depth, walks to the nearest frontier until the goal is seen, then to the goal.
/// Source: Neural Topological SLAM, section 5.1 "Metric Spatial Map + FBE + Local".
class MetricMapFbeAgent final : public MetricMapAgent {
 public:
  static constexpr std::string_view kName = "metric_map_fbe";

  using Config = MetricMapAgentSpec;

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) { return SemanticAndMapSlots(rig); }

  MetricMapFbeAgent(const Config& config, const AgentContext& context)
      : MetricMapAgent(kName, config, context) {}

 private:
  std::optional<sim::Action> GoOn() override { return GoToFrontier(); }
};

const AgentRegistration<MetricMapFbeAgent> registration;

}  // namespace
}  // namespace bulletnav::agent
