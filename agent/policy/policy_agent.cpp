// SPDX-License-Identifier: MIT
#include "agent/policy/policy_agent.h"

#include <algorithm>
#include <utility>

namespace bulletnav::agent {
namespace {

std::shared_ptr<PolicyModel> WithoutMap(std::shared_ptr<PolicyModel> policy) {
  if (!policy->sees_map()) return policy;
  throw sim::Error(
      "these weights are of a policy that is shown a map, which metric_map_rl takes; this agent "
      "needs those of one that is not: name others with models: {policy: FILE}");
}

}  // namespace

PolicyAgent::PolicyAgent(const Config& config, const AgentContext& context)
    : PolicyAgent(config, WithoutMap(context.models.Need<PolicyModel>(kPolicy)), context.rig) {}

PolicyAgent::PolicyAgent(const Config& config, std::shared_ptr<PolicyModel> policy, const Rig& rig)
    : config_(config), policy_(std::move(policy)) {
  if (policy_->sees_map()) map_ = std::make_unique<PolicyMap>(rig);
}

void PolicyAgent::Reset(const Panorama& goal, std::uint64_t seed) {
  goal_ = policy_->CodeOf(goal);
  memory_ = policy_->NoMemory();
  if (map_) map_->Reset();
  last_.reset();
  first_step_.reset();
  stops_in_row_ = 0;
  stopped_in_vain_ = false;
  seed_ = seed;
}

sim::Action PolicyAgent::Act(const Observation& observation) {
  Observation seen = observation;
  if (!first_step_) {
    first_step_ = observation.step;
    seen.odometry = {};
  }
  seen.step -= *first_step_;
  std::array<float, kPolicyNumbers> numbers{};
  WritePolicyNumbers(seen, last_, policy_->step_limit(), numbers);
  PolicyQuestion question = {seen.panorama, goal_, numbers};
  if (map_) {
    map_->See(seen);
    question.map = map_->bytes();
  }
  const std::array<float, 4> probabilities = HoldBackStop(policy_->Act(question, &memory_));
  sim::Rng rng = sim::Rng(seed_, "policy").Fork("step", static_cast<std::uint64_t>(seen.step));
  last_ = sim::kAllActions.at(ChooseAction(probabilities, config_, &rng));
  return *last_;
}

std::array<float, 4> PolicyAgent::HoldBackStop(std::array<float, 4> probabilities) {
  constexpr auto kStop = static_cast<std::size_t>(sim::Action::kStop);
  static_assert(kStop == 0);
  stops_in_row_ = probabilities[kStop] >= config_.stop_from ? stops_in_row_ + 1 : 0;
  const bool else_to_do = std::any_of(probabilities.begin() + 1, probabilities.end(), [](float p) {
    return p > 0.0f;
  });
  if (last_ == sim::Action::kStop) stopped_in_vain_ = true;
  const bool held = stopped_in_vain_ || stops_in_row_ < config_.stop_steps;
  if (held && else_to_do) probabilities[kStop] = 0.0f;
  return probabilities;
}

Belief PolicyAgent::belief() const {
  if (!map_) return {};
  return {map_->pose(), std::nullopt, map_->map().Picture()};
}

std::size_t ChooseAction(std::array<float, 4> probabilities, const PolicyAgent::Config& config,
                         sim::Rng* rng) {
  constexpr auto kStop = static_cast<std::size_t>(sim::Action::kStop);
  if (config.stop_from > 0.0) {
    if (probabilities[kStop] >= config.stop_from) return kStop;
    probabilities[kStop] = 0.0f;
  }
  if (!config.sample) {
    return static_cast<std::size_t>(std::max_element(probabilities.begin(), probabilities.end()) -
                                    probabilities.begin());
  }
  const std::vector<double> weights(probabilities.begin(), probabilities.end());
  return rng->Weighted(weights);
}

}  // namespace bulletnav::agent
