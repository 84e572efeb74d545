// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/actor_critic.h"

#include <algorithm>
#include <vector>

#include "sim/base/elementary.h"

namespace bulletnav::bench {

int ActorCritic::Draw(std::span<const float> log_probabilities, sim::Rng* rng) const {
  std::vector<double> weights(log_probabilities.size());
  std::transform(log_probabilities.begin(), log_probabilities.end(), weights.begin(),
                 [](float value) {
                   return sim::Exp(double{value});
                 });
  return static_cast<int>(rng->Weighted(weights));
}

torch::Tensor ActorCritic::LogProbabilitiesOf(const Output& output,
                                              const torch::Tensor& actions) const {
  return output.log_probabilities.gather(-1, actions.unsqueeze(-1)).squeeze(-1);
}

torch::Tensor ActorCritic::EntropyOf(const Output& output) const {
  return -(output.log_probabilities.exp() * output.log_probabilities).sum(-1);
}

}  // namespace bulletnav::bench
