// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/core/train_task.h"
#include "benchmark/training/core/trainer.h"
#include "benchmark/training/supervised/supervised_data.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// The training of the mapper that agents without depth use, from panoramas with depth; see
/// MapperNet, TrueFreeSpace and LossesOf.
TrainTask MapperTask(const MapperTrainConfig& config, const SupervisedData& data);

}  // namespace bulletnav::bench
