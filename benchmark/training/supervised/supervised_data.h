// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "benchmark/training/core/trainer_registry.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// What a supervised training learns from and is tried on. Somebody else's, or kept by `owner`.
struct SupervisedData {
  const BatchSource& train;
  const BatchSource& validation;
  std::shared_ptr<const void> owner = nullptr;
};

/// Makes the houses that are missing, labels scenes and loads them. Throws sim::Error; see
/// SceneBatches.
SupervisedData LoadSupervisedData(const SupervisedPlan& plan, bool with_depth,
                                  const TrainerContext& context);

/// What the core is told of a plan over such data.
template <class Config>
TrainTask SupervisedTask(const Config& config) {
  TrainTask task = TrainTask::Of(config);
  DescribeData(config, &task);
  return task;
}
void DescribeData(const SupervisedPlan& plan, TrainTask* task);

}  // namespace bulletnav::bench
