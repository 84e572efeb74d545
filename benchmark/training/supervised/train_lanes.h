// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "benchmark/training/supervised/learner.h"
#include "benchmark/training/supervised/train_config.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// The parts that a step of training falls into, which threads take side by side. Each has the
/// parameters of the trained net and gradients and running means of its own, so that what a step
/// comes to depends on the number of lanes and not on that of threads.
class TrainLanes {
 public:
  /// `plan` and `net` must outlive it, the net's parameters stay where they are.
  TrainLanes(const SupervisedPlan& plan, const LearnerMaker& make, torch::nn::Module* net,
             sim::WorkerPool* pool);

  /// Takes the batches of step 0, 1, ... forth and back. The net's gradients and running means
  /// become the means over the lanes. Returns the loss.
  double Pass(const BatchSource& batches, int step);

 private:
  double PassOne(const BatchSource& batches, int step, int lane);
  /// Lets the lanes start from the net's running means, or the net go on from theirs.
  void SpreadBuffers();
  void Gather();

  const SupervisedPlan& plan_;
  torch::nn::Module* net_;
  sim::WorkerPool* pool_;
  std::vector<std::unique_ptr<Learner>> lanes_;
};

}  // namespace bulletnav::bench
