// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/number_net.h"

#include <cmath>
#include <string_view>
#include <vector>

#include "sim/config/yaml_reader.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

/// Normal numbers of the project's generator, of variance gain^2 / inputs.
torch::Tensor Drawn(std::uint64_t seed, std::string_view name, int rows, int columns, double gain) {
  sim::Rng rng(seed, name);
  torch::Tensor weight = torch::empty({rows, columns});
  float* data = weight.data_ptr<float>();
  const double deviation = gain / std::sqrt(columns);
  for (int i = 0; i < rows * columns; ++i) data[i] = static_cast<float>(deviation * rng.Normal());
  return weight;
}

}  // namespace

void NumberNetSpec::Validate() const {
  if (width < 1) throw sim::KeyError("width", "width must be at least 1");
}

NumberNet::NumberNet(const NumberNetSpec& spec, int observation_size, int actions,
                     std::uint64_t seed)
    : spec_(spec) {
  const int width = spec.width;
  const auto drawn = [&](const char* name, int rows, int columns, double gain) {
    return register_parameter(name, Drawn(seed, name, rows, columns, gain));
  };
  const auto zeros = [&](const char* name, int size) {
    return register_parameter(name, torch::zeros({size}));
  };
  in_weight_ = drawn("in_weight", width, observation_size, 1.4);
  in_bias_ = zeros("in_bias", width);
  if (spec.memory) {
    gru_in_ = drawn("gru_in", 3 * width, width, 1.0);
    gru_hidden_ = drawn("gru_hidden", 3 * width, width, 1.0);
    gru_in_bias_ = zeros("gru_in_bias", 3 * width);
    gru_hidden_bias_ = zeros("gru_hidden_bias", 3 * width);
  }
  policy_weight_ = drawn("policy_weight", actions, width, 0.01);
  policy_bias_ = zeros("policy_bias", actions);
  value_weight_ = drawn("value_weight", 1, width, 1.0);
  value_bias_ = zeros("value_bias", 1);
}

torch::Tensor NumberNet::NoMemory(int lanes) const {
  return torch::zeros({lanes, spec_.width});
}

NumberNet::Output NumberNet::Run(const Seen& seen, const torch::Tensor& starts,
                                 const torch::Tensor& hidden) {
  Output out;
  out.hidden = hidden;
  torch::Tensor features = at::tanh(at::linear(seen.numbers, in_weight_, in_bias_));
  if (spec_.memory) features = Remember(features, starts, &out.hidden);
  out.log_probabilities = at::log_softmax(at::linear(features, policy_weight_, policy_bias_), -1);
  out.values = at::linear(features, value_weight_, value_bias_).squeeze(-1);
  return out;
}

torch::Tensor NumberNet::Remember(const torch::Tensor& features, const torch::Tensor& starts,
                                  torch::Tensor* hidden) {
  std::vector<torch::Tensor> steps;
  steps.reserve(static_cast<std::size_t>(features.size(0)));
  for (std::int64_t t = 0; t < features.size(0); ++t) {
    *hidden = *hidden * (1.0 - starts[t]).unsqueeze(1);
    *hidden =
        at::gru_cell(features[t], *hidden, gru_in_, gru_hidden_, gru_in_bias_, gru_hidden_bias_);
    steps.push_back(*hidden);
  }
  return at::stack(steps);
}

}  // namespace bulletnav::bench
