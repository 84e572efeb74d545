// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/train_config.h"
#include "benchmark/training/train_task.h"
#include "benchmark/training/trainer.h"

namespace bulletnav::bench {

/// The training of the mapper that agents without depth use, from panoramas with depth; see
/// MapperNet, TrueFreeSpace and LossesOf.
TrainTask MapperTask(const MapperTrainConfig& config);

}  // namespace bulletnav::bench
