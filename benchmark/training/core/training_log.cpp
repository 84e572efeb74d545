// SPDX-License-Identifier: MIT
#include "benchmark/training/core/training_log.h"

#include <cmath>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

constexpr double kPause = 10.0;  // seconds between lines

std::string TimeText(double seconds) {
  const auto minutes = static_cast<int>(std::lround(seconds / 60.0));
  if (minutes < 1) return fmt::format("{:.0f} s", seconds);
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace

TrainingLog::TrainingLog(const TrainJob& job, std::ostream* out)
    : steps_(job.plan.steps),
      training_(job.training.get()),
      out_(out),
      start_(Clock::now()),
      last_(start_) {}

void TrainingLog::Resumed(int step) {
  first_step_ = step;
  *out_ << fmt::format("going on from step {} of {}\n", step, steps_) << std::flush;
}

void TrainingLog::Stepped(int step, double loss) {
  loss_sum_ += loss;
  ++losses_;
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < kPause) return;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = (step - first_step_) / elapsed_s;
  const auto frames =
      static_cast<double>(training_->FramesAfter(step) - training_->FramesAfter(first_step_));
  *out_ << fmt::format("step {} of {}: loss {:.3f}, {:.1f} steps/s, {:.0f} {}/s, {} left\n", step,
                       steps_, loss_sum_ / losses_, rate, frames / elapsed_s,
                       training_->frames_are(), TimeText((steps_ - step) / rate))
        << std::flush;
  last_ = now;
  loss_sum_ = 0.0;
  losses_ = 0;
}

void TrainingLog::Validating(int step, const std::string& what) {
  validating_ = Clock::now();
  if (!is_quick_) *out_ << fmt::format("trying {} of step {}\n", what, step) << std::flush;
}

void TrainingLog::Validated(int step, const Measures& /*measures*/, const std::string& text) {
  const double took_s = std::chrono::duration<double>(Clock::now() - validating_).count();
  is_quick_ = took_s < kPause;
  *out_ << fmt::format("validation at step {}: {}\n", step, text) << std::flush;
}

}  // namespace bulletnav::bench
