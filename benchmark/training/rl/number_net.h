// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/rl/actor_critic.h"

namespace bulletnav::bench {

struct NumberNetSpec {
  int width = 64;
  bool memory = true;  // false: no recurrence, sees the present observation alone

  template <class V>
  void Visit(V& v) {
    v("width", width);
    v("memory", memory);
  }
  /// Throws Error.
  void Validate() const;
};

/// A recurrent policy on plain numbers: a layer, a GRU, and heads for actions and value.
class NumberNet final : public ActorCritic {
 public:
  NumberNet(const NumberNetSpec& spec, int observation_size, int actions, std::uint64_t seed);

  torch::Tensor Encode(const torch::Tensor& /*pictures*/) override { return {}; }
  bool learns_to_see() const override { return false; }
  Output Run(const Seen& seen, const torch::Tensor& starts, const torch::Tensor& hidden) override;
  torch::Tensor NoMemory(int lanes) const override;

 private:
  torch::Tensor Remember(const torch::Tensor& features, const torch::Tensor& starts,
                         torch::Tensor* hidden);

  NumberNetSpec spec_;
  torch::Tensor in_weight_, in_bias_;
  torch::Tensor gru_in_, gru_hidden_, gru_in_bias_, gru_hidden_bias_;
  torch::Tensor policy_weight_, policy_bias_;
  torch::Tensor value_weight_, value_bias_;
};

}  // namespace bulletnav::bench
