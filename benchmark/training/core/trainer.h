// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/training/core/measures.h"

namespace bulletnav::bench {

struct TrainTask;

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
  /// `text`: the measures in words.
  virtual void Validated(int step, const Measures& measures, const std::string& text) = 0;
};

/// Trains a model and writes to the plan's folder: weights.safetensors, the result;
/// weights.md, a card about it; weights_best.safetensors, of the lowest validation loss so far;
/// curves.csv, curves.svg and curves.png; checkpoints. A training that was killed goes on from its
/// last checkpoint when called again, and ends with the same bits as one that was not, on any
/// number of threads. Throws Error if the loss
/// is no longer a number (the last good checkpoint stays), if a checkpoint is of another config or
/// if another process trains there; FileError if files cannot be written.
void RunTraining(const TrainTask& task, TrainObserver* observer);

}  // namespace bulletnav::bench
