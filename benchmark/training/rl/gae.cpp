// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/gae.h"

#include <cstddef>

#include "sim/base/check.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

void GaeSpec::Validate() const {
  if (!(discount >= 0.0 && discount <= 1.0)) {
    throw sim::KeyError("discount", "discount must be between 0 and 1");
  }
  if (!(lambda >= 0.0 && lambda <= 1.0)) {
    throw sim::KeyError("lambda", "lambda must be between 0 and 1");
  }
}

void EstimateAdvantages(const GaeSpec& spec, std::span<const LaneStep> steps, double last_value,
                        std::span<double> advantages) {
  BULLETNAV_CHECK(steps.size() == advantages.size());
  double next_value = last_value;
  double next_advantage = 0.0;
  for (std::size_t i = steps.size(); i-- > 0;) {
    const LaneStep& step = steps[i];
    if (step.terminated || step.truncated) {
      next_value = step.terminated ? 0.0 : step.cut_value;
      next_advantage = 0.0;
    }
    const double error = step.reward + spec.discount * next_value - step.value;
    next_advantage = error + spec.discount * spec.lambda * next_advantage;
    advantages[i] = next_advantage;
    next_value = step.value;
  }
}

}  // namespace bulletnav::bench
