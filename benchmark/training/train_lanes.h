// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "agent/perception/semantic_net.h"
#include "benchmark/training/nts_loss.h"
#include "benchmark/training/train_config.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// The panoramas of a batch as the model takes them.
torch::Tensor InputOf(const agent::ModelConfig& config, PairBatch* batch);

/// The parts that a step of training falls into, which threads take side by side. Each has the
/// parameters of the trained net and gradients and running means of its own, so that what a step
/// comes to depends on the number of lanes and not on that of threads.
class TrainLanes {
 public:
  /// `config` and `net` must outlive it, the net's parameters stay where they are.
  TrainLanes(const TrainConfig& config, agent::SemanticNet* net, sim::WorkerPool* pool);

  /// Takes the batches of step 0, 1, ... forth and back. The net's gradients and running means
  /// become the means over the lanes. Returns the loss.
  double Pass(const BatchSource& batches, int step);

 private:
  double PassOne(const BatchSource& batches, int step, int lane);
  /// Lets the lanes start from the net's running means, or the net go on from theirs.
  void SpreadBuffers();
  void Gather();

  const TrainConfig& config_;
  agent::SemanticNet* net_;
  sim::WorkerPool* pool_;
  sim::Rng rng_;
  std::vector<std::unique_ptr<agent::SemanticNet>> lanes_;
};

}  // namespace bulletnav::bench
