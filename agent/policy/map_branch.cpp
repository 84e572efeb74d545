// SPDX-License-Identifier: MIT
#include "agent/policy/map_branch.h"

#include <cmath>

namespace bulletnav::agent {

/// 3 x 3, stride 2, with a bias, then ReLU.
class MapBranch::Conv : public torch::nn::Module {
 public:
  Conv(int in, int out, sim::Rng* rng)
      : weight_(register_parameter("weight",
                                   NormalTensor({out, in, 3, 3}, std::sqrt(2.0 / (9 * in)), rng))),
        bias_(register_parameter("bias", torch::zeros({out}))) {}

  torch::Tensor forward(const torch::Tensor& x) {
    return at::conv2d(x, weight_, bias_, 2, 1).relu();
  }

 private:
  torch::Tensor weight_;
  torch::Tensor bias_;
};

MapBranch::MapBranch(sim::Rng* rng) {
  for (std::size_t i = 0; i < kMapConvs.size(); ++i) {
    convs_.push_back(
        register_module(kMapConvs[i], std::make_shared<Conv>(kChannels[i], kChannels[i + 1], rng)));
  }
  whole_ = register_module("whole", std::make_shared<Dense>(kEndSize, kMapFeatures, rng));
}

torch::Tensor MapBranch::Planes(const torch::Tensor& bytes) {
  const torch::Tensor bits = at::arange(8, torch::kInt32);
  const torch::Tensor planes = at::__rshift__(bytes.to(torch::kInt32).unsqueeze(-1), bits)
                                   .bitwise_and(1)
                                   .to(torch::kFloat32)
                                   .view({-1, kMapPlanes, kMapSide, kMapSide});
  return at::constant_pad_nd(planes, {0, 0, 0, 0, 0, kChannels.front() - kMapPlanes});
}

torch::Tensor MapBranch::Flat(const torch::Tensor& ends) {
  return ends.permute({0, 2, 3, 1}).reshape({-1, kEndSize});
}

torch::Tensor MapBranch::forward(const torch::Tensor& bytes) {
  torch::Tensor x = Planes(bytes);
  for (const std::shared_ptr<Conv>& conv : convs_) x = conv->forward(x);
  return whole_->forward(Flat(x)).relu();
}

}  // namespace bulletnav::agent
