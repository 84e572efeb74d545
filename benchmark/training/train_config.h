// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "agent/perception/model_config.h"
#include "benchmark/training/augment.h"
#include "benchmark/training/data_config.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// kCosine: falls to zero at the last step.
enum class Schedule { kConstant, kCosine };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Schedule> {
  static constexpr std::array kNames = {
      std::pair{"constant", bulletnav::bench::Schedule::kConstant},
      std::pair{"cosine", bulletnav::bench::Schedule::kCosine}};
};

namespace bulletnav::bench {

/// Adam. Source: Kingma and Ba, 2014; the rate is of Neural Topological SLAM, appendix A.
struct OptimiserSpec {
  double learning_rate = 5e-4;
  Schedule schedule = Schedule::kCosine;
  int warmup_steps = 200;     // the rate rises to its full height over these
  double weight_decay = 0.0;  // of weights, not of their gradients

  /// The rate of step 0, 1, ... of `steps`.
  double RateAt(int step, int steps) const;

  template <class V>
  void Visit(V& v) {
    v("learning_rate", learning_rate);
    v("schedule", schedule);
    v("warmup_steps", warmup_steps);
    v("weight_decay", weight_decay);
  }
  /// Throws Error.
  void Validate() const;
};

/// A training of the learned model of Neural Topological SLAM.
struct TrainConfig {
  std::string out;                       // folder of all that the training writes
  std::optional<DataConfig> data;        // what SceneBatches learns from
  std::optional<DataConfig> validation;  // and is tried on; default: the houses' split "val"
  agent::ModelConfig model;
  OptimiserSpec optimiser;
  AugmentSpec augment;
  int steps = 20000;
  int scenes = 4;            // batches a step
  int lanes = 2;             // that share them; each normalises by its own batches
  int panoramas = 16;        // in each batch
  int pairs = 64;            // compared of each batch, half of them of one node if there are enough
  int validate_every = 500;  // steps; a checkpoint is written then, too
  int validation_batches = 32;
  std::uint64_t seed = 0;

  template <class V>
  void Visit(V& v) {
    v.Required("out", out);
    v("data", data);
    v("validation", validation);
    v("model", model);
    v("optimiser", optimiser);
    v("augment", augment);
    v("steps", steps);
    v("scenes", scenes);
    v("lanes", lanes);
    v("panoramas", panoramas);
    v("pairs", pairs);
    v("validate_every", validate_every);
    v("validation_batches", validation_batches);
    v("seed", seed);
  }
  /// Throws Error.
  void Validate() const;
};

/// `validation`, or its default. Throws Error if there is neither.
DataConfig ValidationData(const TrainConfig& config);

}  // namespace bulletnav::bench
