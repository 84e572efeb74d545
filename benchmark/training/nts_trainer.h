// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/train_config.h"
#include "benchmark/training/train_task.h"
#include "benchmark/training/trainer.h"

namespace bulletnav::bench {

/// The training of the learned model of Neural Topological SLAM, appendix A.
TrainTask NtsTask(const TrainConfig& config);

}  // namespace bulletnav::bench
