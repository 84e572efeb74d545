// SPDX-License-Identifier: MIT
#include "benchmark/training/train_config.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

void RequireAtLeast(int low, int value, const std::string& name) {
  if (value < low) throw sim::Error(name + " must be at least " + std::to_string(low));
}

void RequireTask(const TrainPlan& plan, Trained trained) {
  if (plan.task.value_or(Trained::kNts) == trained) return;
  throw sim::Error("task must be " + std::string(sim::NameOf(trained)));
}

}  // namespace

double OptimiserSpec::RateAt(int step, int steps) const {
  const double warm = warmup_steps > 0 ? std::min(1.0, (step + 1.0) / warmup_steps) : 1.0;
  if (schedule == Schedule::kConstant) return learning_rate * warm;
  return learning_rate * warm * 0.5 * (1.0 + std::cos(sim::kPi * step / steps));
}

void OptimiserSpec::Validate() const {
  if (!(learning_rate > 0.0 && learning_rate < 1.0)) {
    throw sim::Error("learning_rate must be in (0, 1)");
  }
  if (!(weight_decay >= 0.0 && weight_decay < 1.0)) {
    throw sim::Error("weight_decay must be in [0, 1)");
  }
  RequireAtLeast(0, warmup_steps, "warmup_steps");
}

void TrainPlan::Validate() const {
  if (out.empty()) throw sim::Error("out must name a folder");
  RequireAtLeast(1, steps, "steps");
  RequireAtLeast(1, scenes, "scenes");
  RequireAtLeast(2, panoramas, "panoramas");
  if (!(near_batches.value_or(0.0) >= 0.0 && near_batches.value_or(0.0) <= 1.0)) {
    throw sim::Error("near_batches must be in [0, 1]");
  }
  RequireAtLeast(1, validate_every, "validate_every");
  RequireAtLeast(1, validation_batches, "validation_batches");
  RequireAtLeast(1, lanes, "lanes");
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
  TrainPlan::Validate();
  RequireTask(*this, Trained::kNts);
  RequireAtLeast(2, pairs, "pairs");
  if (!(rejection.value_or(0.0) >= 0.0)) throw sim::Error("rejection must not be negative");
}

void MapperTrainConfig::Validate() const {
  TrainPlan::Validate();
  RequireTask(*this, Trained::kMapper);
  if (!(obstacle_weight > 0.0 && obstacle_weight <= 100.0)) {
    throw sim::Error("obstacle_weight must be in (0, 100]");
  }
}

Trained TrainedBy(const std::filesystem::path& file) {
  const sim::YamlNode root = sim::ParseYaml(sim::ReadYamlFile(file), file);
  root.ExpectMap();
  Trained trained = Trained::kNts;
  const YAML::Node& map = root.yaml();
  if (map["task"]) sim::YamlReader::Read(root.Child(map["task"]), trained);
  return trained;
}

DataConfig ValidationData(const TrainPlan& plan) {
  if (plan.validation) return *plan.validation;
  BULLETNAV_CHECK(plan.data && plan.data->houses);
  DataConfig validation = *plan.data;
  validation.scenes.clear();
  validation.more_houses.reset();
  validation.houses->split = "val";
  return validation;
}

}  // namespace bulletnav::bench
