// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/picture_net.h"

#include <algorithm>
#include <array>

#include "agent/integer/integer_trunk.h"
#include "agent/policy/policy_agent.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {

PictureNet::PictureNet(const agent::PolicyConfig& config, const std::optional<std::string>& encoder,
                       std::uint64_t seed)
    : policy_(register_module("policy", std::make_shared<agent::PolicyNet>(config, seed))) {
  if (encoder && config.own_encoder) agent::TakeEncoder(*encoder, policy_.get());
  if (encoder && !config.own_encoder) agent::TakeIntegerEncoder(*encoder, policy_.get());
}

torch::Tensor PictureNet::Encode(const torch::Tensor& pictures) {
  return policy_->Encode(hides_depth_ ? agent::WithoutDepth(pictures) : pictures);
}

ActorCritic::Output PictureNet::Run(const Seen& seen, const torch::Tensor& starts,
                                    const torch::Tensor& hidden) {
  const agent::PolicyNet::Output output =
      policy_->Run({seen.codes, seen.goal_codes, seen.numbers}, starts, hidden);
  return {at::log_softmax(output.logits, -1), output.values, output.memory};
}

torch::Tensor PictureNet::NoMemory(int lanes) const {
  return torch::zeros({lanes, policy_->config().memory});
}

int PictureNet::Draw(std::span<const float> log_probabilities, sim::Rng* rng) const {
  if (stop_from_ == 0.0) return ActorCritic::Draw(log_probabilities, rng);
  std::array<float, 4> probabilities{};
  std::transform(log_probabilities.begin(), log_probabilities.end(), probabilities.begin(),
                 [](float value) {
                   return static_cast<float>(sim::Exp(double{value}));
                 });
  return static_cast<int>(agent::ChooseAction(probabilities, {.stop_from = stop_from_}, rng));
}

}  // namespace bulletnav::bench
