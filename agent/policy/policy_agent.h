// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/agent.h"
#include "agent/policy/policy_input.h"
#include "agent/policy/policy_model.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

inline constexpr const char* kPolicy = "policy";  // the slot's name

/// Does what a learned policy says, step after step, and stops when that says so.
class PolicyAgent : public Agent {
 public:
  struct Config {
    /// Actions are drawn by their probabilities, as in training; else the likeliest is taken.
    bool sample = true;

    template <class V>
    void Visit(V& v) {
      v("sample", sample);
    }
    void Validate() const {}
  };

  PolicyAgent(const Config& config, const AgentContext& context)
      : PolicyAgent(config, context.models.Need<PolicyModel>(kPolicy)) {}
  PolicyAgent(const Config& config, std::shared_ptr<PolicyModel> policy);

  void Reset(const Panorama& goal, std::uint64_t seed) override;
  /// Another goal is another episode to it, but for where in the place the body is.
  sim::Action Act(const Observation& observation) override;

 private:
  std::size_t Choose(const std::array<float, 4>& probabilities, int step) const;

  Config config_;
  std::shared_ptr<PolicyModel> policy_;
  std::vector<float> goal_;
  std::vector<float> memory_;
  std::optional<sim::Action> last_;
  std::optional<int> first_step_;  // of the way to this goal
  std::uint64_t seed_ = 0;
};

}  // namespace bulletnav::agent
