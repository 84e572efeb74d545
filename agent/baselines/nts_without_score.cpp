// SPDX-License-Identifier: MIT
#include "agent/nts/nts_agent.h"
#include "agent/registry.h"

namespace bulletnav::agent {
namespace {

/// Neural Topological SLAM that explores ghost nodes at random: the ablation "NTS w/o Score" of
/// section 6.1.
class NtsWithoutScore final : public NtsAgent {
 public:
  static constexpr std::string_view kName = "nts_without_score";

  NtsWithoutScore(const Config& config, const AgentContext& context)
      : NtsAgent(config, context, GhostChoice::kRandom) {}
};

const AgentRegistration<NtsWithoutScore> registration;

}  // namespace
}  // namespace bulletnav::agent
