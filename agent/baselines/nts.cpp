// SPDX-License-Identifier: MIT
#include "agent/nts/nts_agent.h"
#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

/// Neural Topological SLAM.
class Nts final : public NtsAgent {
 public:
  static constexpr std::string_view kName = "nts";

  Nts(const Config& config, const AgentContext& context)
      : NtsAgent(config, context, GhostChoice::kScore) {}
};

const AgentRegistration<Nts> registration;

}  // namespace
}  // namespace bulletnav::agent
