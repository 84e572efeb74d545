// SPDX-License-Identifier: MIT
#include "benchmark/training/core/net_parts.h"

#include <vector>

namespace bulletnav::bench {

void ShareParameters(const torch::nn::Module& net, const torch::nn::Module& part) {
  const std::vector<torch::Tensor> shared = net.parameters();
  const std::vector<torch::Tensor> own = part.parameters();
  for (std::size_t k = 0; k < own.size(); ++k) torch::Tensor(own[k]).set_data(shared[k].data());
}

void TakeGradients(const torch::nn::Module& part, double share, const torch::nn::Module& net) {
  const torch::NoGradGuard no_grad;
  const std::vector<torch::Tensor> parameters = net.parameters();
  const std::vector<torch::Tensor> own = part.parameters();
  for (std::size_t k = 0; k < own.size(); ++k) {
    torch::Tensor& gradient = own[k].mutable_grad();
    if (!gradient.defined()) continue;
    torch::Tensor& sum = parameters[k].mutable_grad();
    sum = sum.defined() ? sum.add_(gradient, share) : gradient.mul_(share);
    gradient.reset();
  }
}

}  // namespace bulletnav::bench
