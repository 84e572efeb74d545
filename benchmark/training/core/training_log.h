// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <ostream>
#include <string>

#include "benchmark/training/core/trainer.h"

namespace bulletnav::bench {

/// Tells a person how a training goes: a line every ten seconds with the loss, the rate and the
/// time left, and one for each validation.
class TrainingLog : public TrainObserver {
 public:
  TrainingLog(const TrainJob& job, std::ostream* out);

  void Resumed(int step) override;
  void Stepped(int step, double loss) override;
  void Validating(int step, const std::string& what) override;
  void Validated(int step, const Measures& measures, const std::string& text) override;

 private:
  using Clock = std::chrono::steady_clock;

  int steps_;
  const Training* training_;
  std::ostream* out_;
  int first_step_ = 0;
  Clock::time_point start_;
  Clock::time_point last_;
  bool is_quick_ = false;         // the last validation was
  Clock::time_point validating_;  // since when
  double loss_sum_ = 0.0;
  int losses_ = 0;
};

}  // namespace bulletnav::bench
