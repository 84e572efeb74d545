// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/train_lanes.h"

#include <numeric>

#include "agent/perception/one_thread.h"
#include "benchmark/training/core/net_parts.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

TrainLanes::TrainLanes(const SupervisedPlan& plan, const LearnerMaker& make, torch::nn::Module* net,
                       sim::WorkerPool* pool)
    : plan_(plan), net_(net), pool_(pool) {
  for (int i = 0; i < plan_.lanes; ++i) {
    lanes_.push_back(make());
    if (plan_.device == Device::kCuda) lanes_.back()->net().to(torch::kCUDA);
    ShareParameters(*net, lanes_.back()->net());
    lanes_.back()->net().train();
  }
}

double TrainLanes::Pass(const BatchSource& batches, int step) {
  SpreadBuffers();
  std::vector<double> losses(lanes_.size());
  pool_->ForEach(plan_.lanes, [&](int lane, int) {
    losses[static_cast<std::size_t>(lane)] = PassOne(batches, step, lane);
  });
  Gather();
  return std::accumulate(losses.begin(), losses.end(), 0.0) / plan_.lanes;
}

double TrainLanes::PassOne(const BatchSource& batches, int step, int lane) {
  agent::StayInThisThread();
  const auto at = static_cast<std::uint64_t>(step);
  LaneWork work;
  work.batches = &batches;
  work.step = step;
  work.count = plan_.scenes / plan_.lanes;
  work.first =
      at * static_cast<std::uint64_t>(plan_.scenes) + static_cast<std::uint64_t>(lane * work.count);
  work.seed = sim::MixSeed(
      plan_.seed, at * static_cast<std::uint64_t>(plan_.lanes) + static_cast<std::uint64_t>(lane));
  const torch::Tensor loss = lanes_[static_cast<std::size_t>(lane)]->Loss(work);
  loss.backward();
  return loss.item<double>();
}

void TrainLanes::SpreadBuffers() {
  const torch::NoGradGuard no_grad;
  const std::vector<torch::Tensor> from = net_->buffers();
  for (const auto& lane : lanes_) {
    const std::vector<torch::Tensor> to = lane->net().buffers();
    for (std::size_t k = 0; k < to.size(); ++k) to[k].copy_(from[k]);
  }
}

void TrainLanes::Gather() {
  const torch::NoGradGuard no_grad;
  const double share = 1.0 / plan_.lanes;
  const std::vector<torch::Tensor> buffers = net_->buffers();
  for (const torch::Tensor& buffer : buffers) buffer.zero_();
  for (const auto& lane : lanes_) {
    const std::vector<torch::Tensor> means = lane->net().buffers();
    for (std::size_t k = 0; k < means.size(); ++k) buffers[k].add_(means[k], share);
    TakeGradients(lane->net(), share, *net_);
  }
}

}  // namespace bulletnav::bench
