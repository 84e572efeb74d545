// SPDX-License-Identifier: MIT
#include "benchmark/training/core/train_plan.h"

#include <algorithm>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

void internal::RequireAtLeast(int low, int value, const std::string& name) {
  if (value < low) throw sim::Error(name + " must be at least " + std::to_string(low));
}

double OptimiserSpec::RateAt(int step, int steps, int begin) const {
  const double warm = warmup_steps > 0 ? std::min(1.0, (step - begin + 1.0) / warmup_steps) : 1.0;
  if (schedule == Schedule::kConstant) return learning_rate * warm;
  return learning_rate * warm * 0.5 * (1.0 + sim::Cos(sim::kPi * step / steps));
}

void OptimiserSpec::Validate() const {
  if (!(learning_rate > 0.0 && learning_rate < 1.0)) {
    throw sim::Error("learning_rate must be in (0, 1)");
  }
  if (!(weight_decay >= 0.0 && weight_decay < 1.0)) {
    throw sim::Error("weight_decay must be in [0, 1)");
  }
  if (!(epsilon > 0.0 && epsilon < 1.0)) throw sim::Error("epsilon must be in (0, 1)");
  internal::RequireAtLeast(0, warmup_steps, "warmup_steps");
}

void TrainPlan::Validate() const {
  if (out.empty()) throw sim::Error("out must name a folder");
  internal::RequireAtLeast(1, steps, "steps");
  internal::RequireAtLeast(1, validate_every, "validate_every");
}

}  // namespace bulletnav::bench
