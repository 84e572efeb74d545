// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/lane_groups.h"

#include <cmath>

#include "agent/perception/one_thread.h"
#include "benchmark/training/core/net_parts.h"
#include "sim/base/check.h"

namespace bulletnav::bench {

LaneGroups::LaneGroups(int lanes, int group, const ActorCriticMaker& make, ActorCritic* net,
                       sim::WorkerPool* pool)
    : group_(group), net_(net), pool_(pool) {
  BULLETNAV_CHECK(group >= 1 && lanes % group == 0);
  for (int i = 0; i < lanes / group; ++i) {
    nets_.push_back(make());
    ShareParameters(*net, *nets_.back());
    const std::vector<torch::Tensor> fixed = net->buffers();
    const std::vector<torch::Tensor> copies = nets_.back()->buffers();
    for (std::size_t k = 0; k < copies.size(); ++k) torch::Tensor(copies[k]).set_data(fixed[k]);
    nets_.back()->train();
  }
}

torch::Tensor LaneGroups::LanesOf(int group) const {
  return torch::arange(std::int64_t{group} * group_, std::int64_t{group + 1} * group_,
                       torch::kInt64);
}

std::vector<double> LaneGroups::Differentiate(const std::vector<int>& groups,
                                              const GroupLoss& loss) {
  std::vector<double> losses(groups.size());
  pool_->ForEach(static_cast<int>(groups.size()), [&](int i, int) {
    agent::StayInThisThread();
    const auto at = static_cast<std::size_t>(i);
    const torch::Tensor of_group =
        loss(groups[at], nets_[static_cast<std::size_t>(groups[at])].get());
    of_group.backward();
    losses[at] = of_group.item<double>();
  });
  const double share = 1.0 / static_cast<double>(groups.size());
  for (const int group : groups) {
    TakeGradients(*nets_[static_cast<std::size_t>(group)], share, *net_);
  }
  return losses;
}

double LimitGradients(const torch::nn::Module& net, double limit) {
  double squares = 0.0;
  for (const torch::Tensor& parameter : net.parameters()) {
    if (!parameter.grad().defined()) continue;
    squares += parameter.grad().square().sum().item<double>();
  }
  const double norm = std::sqrt(squares);
  if (norm <= limit) return norm;
  for (const torch::Tensor& parameter : net.parameters()) {
    if (parameter.grad().defined()) parameter.mutable_grad().mul_(limit / norm);
  }
  return norm;
}

}  // namespace bulletnav::bench
