// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/train_config.h"

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

void RequireAtLeast(int low, int value, const std::string& name) {
  if (value < low) throw sim::Error(name + " must be at least " + std::to_string(low));
}

void RequireTask(const TrainPlan& plan, const std::string& name) {
  if (plan.task.value_or("nts") != name) throw sim::Error("task must be " + name);
}

}  // namespace

void SupervisedPlan::Validate() const {
  TrainPlan::Validate();
  RequireAtLeast(1, scenes, "scenes");
  RequireAtLeast(2, panoramas, "panoramas");
  if (!(near_batches.value_or(0.0) >= 0.0 && near_batches.value_or(0.0) <= 1.0)) {
    throw sim::Error("near_batches must be in [0, 1]");
  }
  RequireAtLeast(1, validation_batches, "validation_batches");
  if (scenes % lanes != 0) {
    throw sim::KeyError(
        "scenes", fmt::format("scenes is {}; it must be a multiple of lanes, {}", scenes, lanes));
  }
  if (data && !validation && !data->houses) {
    throw sim::KeyError("data",
                        "names no 'houses' whose split 'val' would serve to validate; add "
                        "a block 'validation'");
  }
}

void ScoreContrast::Validate() const {
  if (!(weight >= 0.0)) throw sim::Error("weight must not be negative");
  RequireAtLeast(0, from_step, "from_step");
}

void TrainConfig::Validate() const {
  SupervisedPlan::Validate();
  RequireTask(*this, "nts");
  RequireAtLeast(2, pairs, "pairs");
  if (!(rejection.value_or(0.0) >= 0.0)) throw sim::Error("rejection must not be negative");
}

void MapperTrainConfig::Validate() const {
  SupervisedPlan::Validate();
  RequireTask(*this, "mapper");
  if (!(obstacle_weight > 0.0 && obstacle_weight <= 100.0)) {
    throw sim::Error("obstacle_weight must be in (0, 100]");
  }
}

DataConfig ValidationData(const SupervisedPlan& plan) {
  if (plan.validation) return *plan.validation;
  BULLETNAV_CHECK(plan.data && plan.data->houses);
  DataConfig validation = *plan.data;
  validation.scenes.clear();
  validation.more_houses.reset();
  validation.houses->split = "val";
  return validation;
}

}  // namespace bulletnav::bench
