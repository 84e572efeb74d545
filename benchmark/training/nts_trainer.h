// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/training/pair_batch.h"
#include "benchmark/training/train_config.h"

namespace bulletnav::bench {

struct NtsMetrics;

/// Is told how a training goes. Steps count from 1.
class TrainObserver {
 public:
  TrainObserver() = default;
  virtual ~TrainObserver() = default;
  TrainObserver(const TrainObserver&) = delete;
  TrainObserver& operator=(const TrainObserver&) = delete;
  TrainObserver(TrainObserver&&) = delete;
  TrainObserver& operator=(TrainObserver&&) = delete;

  virtual void Resumed(int step) = 0;
  virtual void Stepped(int step, double loss) = 0;
  virtual void Validated(int step, const NtsMetrics& metrics) = 0;
};

/// Trains the learned model of Neural Topological SLAM, appendix A, and writes to config.out:
/// weights.safetensors, the result; weights_best.safetensors, of the lowest validation loss so far;
/// curves.csv, curves.svg and curves.png; checkpoints. A training that was killed goes on
/// from its last checkpoint when called again, and ends with the same bits as one that was not, on
/// any number of threads. Validation batches are number 0 on of `validation`.
/// Throws Error if the loss is no longer a number (the last good checkpoint stays), if a checkpoint
/// is of another config or if another process trains there; FileError if files cannot be written.
void TrainNts(const TrainConfig& config, const BatchSource& train, const BatchSource& validation,
              TrainObserver* observer);

}  // namespace bulletnav::bench
