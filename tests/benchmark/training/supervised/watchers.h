// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/training/core/training_log.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::tests {

/// Ends a training like a kill would: after a step, anywhere.
struct Killed {};

/// Remembers what it is told, and kills the training after step `kill_at`.
class Watcher : public bench::TrainObserver {
 public:
  explicit Watcher(int kill_at = 0) : kill_at_(kill_at) {}
  void Resumed(int step) override { resumed_ = step; }
  void Stepped(int step, double /*loss*/) override {
    if (step == kill_at_) throw Killed();
  }
  void Validated(int /*step*/, const bench::Measures& measures, const std::string& text) override {
    measures_ = measures;
    text_ = text;
  }
  int resumed() const { return resumed_; }
  const bench::Measures& measures() const { return measures_; }
  const std::string& text() const { return text_; }

 private:
  int kill_at_;
  int resumed_ = 0;
  bench::Measures measures_;
  std::string text_;
};

/// A log that can be asked how the last validation went.
class LastMeasures : public bench::TrainingLog {
 public:
  using TrainingLog::TrainingLog;
  void Validated(int step, const bench::Measures& measures, const std::string& text) override {
    TrainingLog::Validated(step, measures, text);
    measures_ = measures;
  }
  double at(const std::string& name) const { return measures_.at(name); }

 private:
  bench::Measures measures_;
};

/// A model and a training of some seconds.
template <class Config>
Config TinyTraining(const std::filesystem::path& out) {
  Config config;
  config.out = out;
  config.model.width = 8;
  config.model.rows = 32;
  config.optimiser.warmup_steps = 2;
  config.steps = 6;
  config.scenes = 2;
  config.panoramas = 4;
  config.validate_every = 2;
  config.validation_batches = 1;
  return config;
}

}  // namespace bulletnav::tests
