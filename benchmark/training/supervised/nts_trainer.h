// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/core/train_task.h"
#include "benchmark/training/core/trainer.h"
#include "benchmark/training/supervised/supervised_data.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// The training of the learned model of Neural Topological SLAM, appendix A.
TrainTask NtsTask(const TrainConfig& config, const SupervisedData& data);

}  // namespace bulletnav::bench
