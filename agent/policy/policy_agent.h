// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/agent.h"
#include "agent/policy/policy_input.h"
#include "agent/policy/policy_map.h"
#include "agent/policy/policy_model.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

inline constexpr const char* kPolicy = "policy";  // the slot's name

/// Does what a learned policy says, step after step, and stops when that says so.
class PolicyAgent : public Agent {
 public:
  struct Config {
    /// Actions are drawn by their probabilities, as in training; else the likeliest is taken.
    bool sample = true;
    /// The body stops if, and only if, the policy's probability of a stop is at least this, and
    /// other actions are drawn among themselves: a stop ends the episode, so that small
    /// probabilities of one add up. 0: a stop is an action like others.
    double stop_from = 0.0;
    /// So many steps in a row must say so first, each at least stop_from; meanwhile the body goes
    /// on. The probability of a stop flickers where it passes by.
    int stop_steps = 1;

    template <class V>
    void Visit(V& v) {
      v("sample", sample);
      v("stop_from", stop_from);
      v("stop_steps", stop_steps);
    }
    void Validate() const {
      if (!(stop_from >= 0.0 && stop_from < 1.0)) throw sim::Error("stop_from must be in [0, 1)");
      if (stop_steps < 1) throw sim::Error("stop_steps must be at least 1");
      if (stop_steps > 1 && stop_from == 0.0) {
        throw sim::Error(
            "stop_steps needs stop_from: say from which probability on a step counts, or set "
            "stop_steps: 1");
      }
    }
  };

  /// Throws Error if the policy sees a map: MetricMapRl takes those.
  PolicyAgent(const Config& config, const AgentContext& context);
  /// Throws Error if the policy sees a map and the rig has no depth.
  PolicyAgent(const Config& config, std::shared_ptr<PolicyModel> policy, const Rig& rig = {});

  void Reset(const Panorama& goal, std::uint64_t seed) override;
  /// Another goal is another episode to it, but for where in the place the body is.
  sim::Action Act(const Observation& observation) override;
  Belief belief() const override;

 private:
  /// Without the probability of a stop, if too few steps in a row have said so, or if the body
  /// has stopped before and the episode went on: to stop is then of no use.
  std::array<float, 4> HoldBackStop(std::array<float, 4> probabilities);

  Config config_;
  std::shared_ptr<PolicyModel> policy_;
  std::unique_ptr<PolicyMap> map_;  // of a policy that sees it
  std::vector<float> goal_;
  std::vector<float> memory_;
  std::optional<sim::Action> last_;
  std::optional<int> first_step_;  // of the way to this goal
  int stops_in_row_ = 0;           // steps that said so, up to now
  bool stopped_in_vain_ = false;
  std::uint64_t seed_ = 0;
};

/// How the shipped policies act in runs, those that imitate and those that learned by reward;
/// chosen on goals of the validation houses.
inline constexpr PolicyAgent::Config kAfterImitation = {
    .sample = true, .stop_from = 0.4, .stop_steps = 2};
inline constexpr PolicyAgent::Config kAfterReward = {
    .sample = true, .stop_from = 0.25, .stop_steps = 2};

/// An action, an index into sim::kAllActions, by the probabilities of all four.
std::size_t ChooseAction(std::array<float, 4> probabilities, const PolicyAgent::Config& config,
                         sim::Rng* rng);

}  // namespace bulletnav::agent
