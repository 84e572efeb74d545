// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "benchmark/training/core/peers.h"
#include "benchmark/training/core/train_plan.h"
#include "benchmark/training/core/training.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {

/// A training that is ready to run.
struct TrainJob {
  std::string task;  // its trainer's name
  TrainPlan plan;
  bool heeds_device = true;  // see TrainPlan
  std::string config;        // all that the user said, as YAML
  /// The same without the folder, and without `steps` where no step heeds them: what each step
  /// follows from.
  std::string essence;
  std::unique_ptr<Training> training;

  template <class T>
  static TrainJob Of(typename T::Config config, std::unique_ptr<T> training) {
    TrainJob job;
    job.task = T::kName;
    job.plan = config;
    job.heeds_device = config.heeds_device();
    job.config = sim::ToYaml(config);
    config.out.clear();
    if (!config.heeds_steps()) config.steps = 0;
    job.essence = sim::ToYaml(config);
    job.training = std::move(training);
    return job;
  }
};

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
  /// Before the net, or a form of it, is tried, which may take minutes.
  virtual void Validating(int /*step*/, const std::string& /*what*/) {}
  /// `text`: the measures in words.
  virtual void Validated(int step, const Measures& measures, const std::string& text) = 0;
};

/// Trains and writes to the plan's folder: weights.safetensors, the result; weights.md, a card
/// about it; weights_best.safetensors, of the lowest validation loss so far; curves.csv, curves.svg
/// and curves.png; checkpoints. A training that was killed goes on from its last checkpoint when
/// called again with a job made anew, and on the processor ends with the same bits as one that was
/// not. Weights' metadata: `step`, `frames`, `task` and `training`, the config. Throws Error if the
/// loss is no longer a number (the last good checkpoint stays), if a checkpoint is of another
/// config or of a later step than the plan's last, if another process trains there or if the device
/// is missing; FileError if files cannot be written.
/// `peers` (null: alone) train together; the first reads and writes the folder, and the result is
/// that of one process. Throws Error if the task cannot be shared, and what Peers throws.
void RunTraining(const TrainJob& job, TrainObserver* observer, Peers* peers = nullptr);

/// Throws KeyError if torch has no such device here, or the task no use for it.
void RequireDevice(const TrainPlan& plan, bool heeds_device);

}  // namespace bulletnav::bench
