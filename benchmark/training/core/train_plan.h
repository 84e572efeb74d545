// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

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

/// What all trainings are told. Configs derive from it and visit its members in an order of their
/// own.
struct TrainPlan {
  std::optional<std::string> task;  // a registered trainer; default: nts
  std::string out;                  // folder of all that the training writes
  OptimiserSpec optimiser;
  int steps = 20000;
  int lanes = 2;             // that share a step's batches; each normalises by its own
  int validate_every = 500;  // steps; a checkpoint is written then, too
  std::uint64_t seed = 0;

  /// Throws Error.
  void Validate() const;
};

}  // namespace bulletnav::bench
