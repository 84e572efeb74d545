// SPDX-License-Identifier: MIT
#include "benchmark/training/train_lanes.h"

#include <numeric>

#include "agent/perception/one_thread.h"
#include "benchmark/training/augment.h"
#include "sim/base/check.h"

namespace bulletnav::bench {

torch::Tensor InputOf(const agent::ModelConfig& config, PairBatch* batch) {
  const torch::Tensor color = torch::from_blob(
      batch->color.data(), {batch->count, agent::kPanoramaRows, agent::kPanoramaCols, 3},
      torch::kUInt8);
  torch::Tensor depth;
  if (config.uses_depth()) {
    CHECK(!batch->depth.empty());
    depth = torch::from_blob(batch->depth.data(),
                             {batch->count, agent::kPanoramaRows, agent::kPanoramaCols},
                             torch::kFloat32);
  }
  return agent::PrepareInput(config, color, depth);
}

TrainLanes::TrainLanes(const TrainConfig& config, agent::SemanticNet* net, sim::WorkerPool* pool)
    : config_(config), net_(net), pool_(pool), rng_(config.seed, "train_nts") {
  for (int i = 0; i < config.lanes; ++i) {
    lanes_.push_back(std::make_unique<agent::SemanticNet>(config.model, config.seed));
    const std::vector<torch::Tensor> shared = net->parameters();
    const std::vector<torch::Tensor> own = lanes_.back()->parameters();
    for (std::size_t k = 0; k < own.size(); ++k) torch::Tensor(own[k]).set_data(shared[k].data());
    lanes_.back()->train();
  }
}

double TrainLanes::Pass(const BatchSource& batches, int step) {
  SpreadBuffers();
  std::vector<double> losses(lanes_.size());
  pool_->ForEach(config_.lanes, [&](int lane, int) {
    losses[static_cast<std::size_t>(lane)] = PassOne(batches, step, lane);
  });
  Gather();
  return std::accumulate(losses.begin(), losses.end(), 0.0) / config_.lanes;
}

double TrainLanes::PassOne(const BatchSource& batches, int step, int lane) {
  agent::StayInThisThread();
  const int scenes = config_.scenes / config_.lanes;
  std::vector<torch::Tensor> inputs;
  std::vector<LabelledPairs> labels;
  for (int i = 0; i < scenes; ++i) {
    const auto number =
        static_cast<std::uint64_t>(step) * static_cast<std::uint64_t>(config_.scenes) +
        static_cast<std::uint64_t>(lane * scenes + i);
    PairBatch batch = batches.Batch(number);
    batch.Check();
    Augment(config_.augment, rng_.Fork("augment", number), &batch);
    inputs.push_back(InputOf(config_.model, &batch));
    labels.push_back(Labels(batch, DrawPairs(batch, config_.pairs, rng_.Fork("pairs", number))));
  }
  const LabelledPairs all = Join(labels);
  const auto seed = sim::MixSeed(
      config_.seed, static_cast<std::uint64_t>(step) * static_cast<std::uint64_t>(config_.lanes) +
                        static_cast<std::uint64_t>(lane));
  agent::SemanticNet& net = *lanes_[static_cast<std::size_t>(lane)];
  const agent::PanoramaParts parts =
      net.Describe(at::cat(inputs), at::detail::createCPUGenerator(seed));
  const torch::Tensor total =
      Losses(parts.explorable, net.Compare(parts.Select(all.source), parts.Select(all.goal)), all)
          .Total();
  total.backward();
  return total.item<double>();
}

void TrainLanes::SpreadBuffers() {
  const torch::NoGradGuard no_grad;
  const std::vector<torch::Tensor> from = net_->buffers();
  for (const auto& lane : lanes_) {
    const std::vector<torch::Tensor> to = lane->buffers();
    for (std::size_t k = 0; k < to.size(); ++k) to[k].copy_(from[k]);
  }
}

void TrainLanes::Gather() {
  const torch::NoGradGuard no_grad;
  const double share = 1.0 / config_.lanes;
  const std::vector<torch::Tensor> buffers = net_->buffers();
  for (const torch::Tensor& buffer : buffers) buffer.zero_();
  const std::vector<torch::Tensor> parameters = net_->parameters();
  for (const auto& lane : lanes_) {
    const std::vector<torch::Tensor> means = lane->buffers();
    for (std::size_t k = 0; k < means.size(); ++k) buffers[k].add_(means[k], share);
    const std::vector<torch::Tensor> own = lane->parameters();
    for (std::size_t k = 0; k < own.size(); ++k) {
      torch::Tensor& part = own[k].mutable_grad();
      if (!part.defined()) continue;
      torch::Tensor& sum = parameters[k].mutable_grad();
      sum = sum.defined() ? sum.add_(part, share) : part.mul_(share);
      part.reset();
    }
  }
}

}  // namespace bulletnav::bench
