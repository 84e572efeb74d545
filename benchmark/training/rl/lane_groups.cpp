// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/lane_groups.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "benchmark/training/core/net_parts.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

/// Adds up [lo, hi) into the first of them: first each half, then both.
void AddTree(int lo, int hi, const std::function<void(int to, int from)>& add) {
  if (hi - lo < 2) return;
  const int middle = lo + (hi - lo) / 2;
  AddTree(lo, middle, add);
  AddTree(middle, hi, add);
  add(lo, middle);
}

/// `from` has no gradients after that.
void AddGradients(const torch::nn::Module& from, const torch::nn::Module& to) {
  const std::vector<torch::Tensor> sources = from.parameters();
  const std::vector<torch::Tensor> sums = to.parameters();
  for (std::size_t k = 0; k < sources.size(); ++k) {
    torch::Tensor& gradient = sources[k].mutable_grad();
    if (!gradient.defined()) continue;
    torch::Tensor& sum = sums[k].mutable_grad();
    sum = sum.defined() ? sum.add_(gradient) : gradient;
    gradient.reset();
  }
}

/// One after the other; those that are not there are left out.
torch::Tensor FlatGradients(const torch::nn::Module& net) {
  std::vector<torch::Tensor> parts;
  for (const torch::Tensor& parameter : net.parameters()) {
    if (parameter.grad().defined()) parts.push_back(parameter.grad().reshape({-1}));
  }
  return at::cat(parts);
}

}  // namespace

LaneShare ShareOf(int lanes, int group, int minibatches, const Peers* peers) {
  const int size = peers == nullptr ? 1 : peers->size();
  if (size == 1) return {lanes, 0};
  const bool is_power = (size & (size - 1)) == 0;
  if (!is_power || lanes / group / minibatches % size != 0) {
    throw sim::Error(fmt::format(
        "{} processes cannot share {} lanes in groups of {} and {} minibatches: processes must be "
        "2, 4, 8, ..., and lanes / group / minibatches a multiple of them; start fewer, or change "
        "the config",
        size, lanes, group, minibatches));
  }
  return {lanes / size, peers->rank() * (lanes / size)};
}

void RequireGroups(int lanes, int group, int minibatches) {
  if (group < 1 || lanes % group != 0) throw sim::KeyError("group", "group must divide lanes");
  if (minibatches < 1 || lanes / group % minibatches != 0) {
    throw sim::KeyError("minibatches",
                        "minibatches must divide the number of groups, lanes / group");
  }
}

std::vector<std::vector<int>> DrawMinibatches(int groups, int count, sim::Rng* rng) {
  BULLETNAV_CHECK(count >= 1 && groups % count == 0);
  std::vector<std::vector<int>> all(static_cast<std::size_t>(count));
  for (int first = 0; first < groups; first += count) {
    std::vector<int> neighbours(all.size());
    std::iota(neighbours.begin(), neighbours.end(), first);
    rng->Shuffle(neighbours);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].push_back(neighbours[i]);
  }
  return all;
}

LaneGroups::LaneGroups(int lanes, int group, const ActorCriticMaker& make, ActorCritic* net,
                       sim::WorkerPool* pool, Peers* peers)
    : group_(group),
      groups_(lanes / group),
      first_(ShareOf(lanes, group, 1, peers).first / group),
      net_(net),
      pool_(pool),
      peers_(peers) {
  BULLETNAV_CHECK(group >= 1 && lanes % group == 0);
  for (int i = 0; i < ShareOf(lanes, group, 1, peers).lanes / group; ++i) {
    nets_.push_back(make());
    ShareParameters(*net, *nets_.back());
    const std::vector<torch::Tensor> fixed = net->buffers();
    const std::vector<torch::Tensor> copies = nets_.back()->buffers();
    for (std::size_t k = 0; k < copies.size(); ++k) torch::Tensor(copies[k]).set_data(fixed[k]);
    nets_.back()->train();
  }
}

std::vector<int> LaneGroups::Own(const std::vector<int>& groups) const {
  std::vector<int> own;
  std::copy_if(groups.begin(), groups.end(), std::back_inserter(own), [this](int group) {
    return group >= first_ && group < first_ + static_cast<int>(nets_.size());
  });
  return own;
}

torch::Tensor LaneGroups::LanesOf(int group) const {
  const int own = group - first_;
  BULLETNAV_CHECK(own >= 0 && own < static_cast<int>(nets_.size()));
  return torch::arange(std::int64_t{own} * group_, std::int64_t{own + 1} * group_, torch::kInt64);
}

std::vector<double> LaneGroups::Gather(std::span<const double> own) {
  if (peers_ == nullptr) return {own.begin(), own.end()};
  return peers_->Gather(own);
}

std::vector<double> LaneGroups::Differentiate(const std::vector<int>& groups,
                                              const GroupLoss& loss) {
  const std::vector<int> own = Own(groups);
  std::vector<double> losses(own.size());
  pool_->ForEach(static_cast<int>(own.size()), [&](int i, int) {
    agent::StayInThisThread();
    const auto at = static_cast<std::size_t>(i);
    const torch::Tensor of_group = loss(own[at], NetOf(own[at]));
    of_group.backward();
    losses[at] = of_group.item<double>();
  });
  const torch::NoGradGuard no_grad;
  AddTree(0, static_cast<int>(own.size()), [&](int to, int from) {
    AddGradients(*NetOf(own[static_cast<std::size_t>(from)]),
                 *NetOf(own[static_cast<std::size_t>(to)]));
  });
  TakeSum(NetOf(own.front()), 1.0 / static_cast<double>(groups.size()));
  return Gather(losses);
}

/// The sum over all processes, times `share`, to the trained net.
void LaneGroups::TakeSum(ActorCritic* summed, double share) {
  const std::vector<torch::Tensor> own = summed->parameters();
  const std::vector<torch::Tensor> parameters = net_->parameters();
  torch::Tensor all;
  if (peers_ != nullptr && peers_->size() > 1) {
    all = peers_->Gather(FlatGradients(*summed));
    AddTree(0, peers_->size(), [&](int to, int from) {
      all[to].add_(all[from]);
    });
  }
  std::int64_t at = 0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    torch::Tensor& gradient = own[k].mutable_grad();
    torch::Tensor& mean = parameters[k].mutable_grad();
    mean.reset();
    if (!gradient.defined()) continue;
    const std::int64_t size = gradient.numel();
    mean = all.defined() ? all[0].narrow(0, at, size).view_as(gradient).mul(share)
                         : gradient.mul_(share);
    gradient.reset();
    at += size;
  }
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
