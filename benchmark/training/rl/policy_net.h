// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"

namespace bulletnav::bench {

struct PolicyNetSpec {
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
class PolicyNet final : public torch::nn::Module {
 public:
  struct Output {
    torch::Tensor log_probabilities;  // [steps, lanes, actions]
    torch::Tensor values;             // [steps, lanes], normalised
    torch::Tensor hidden;             // [lanes, width], after the last step
  };

  PolicyNet(const PolicyNetSpec& spec, int observation_size, int actions, std::uint64_t seed);

  /// `observations` [steps, lanes, size]; `starts` [steps, lanes], 1 where an episode begins: the
  /// hidden state [lanes, width] that comes in is then zero.
  Output Run(const torch::Tensor& observations, const torch::Tensor& starts,
             const torch::Tensor& hidden);
  torch::Tensor NoMemory(int lanes) const;

 private:
  torch::Tensor Remember(const torch::Tensor& features, const torch::Tensor& starts,
                         torch::Tensor* hidden);

  PolicyNetSpec spec_;
  torch::Tensor in_weight_, in_bias_;
  torch::Tensor gru_in_, gru_hidden_, gru_in_bias_, gru_hidden_bias_;
  torch::Tensor policy_weight_, policy_bias_;
  torch::Tensor value_weight_, value_bias_;
};

}  // namespace bulletnav::bench
