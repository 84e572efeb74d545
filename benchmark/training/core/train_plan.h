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
/// Where a training reckons. The same bits each time are promised for kCpu alone.
enum class Device { kCpu, kCuda };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Schedule> {
  static constexpr std::array kNames = {
      std::pair{"constant", bulletnav::bench::Schedule::kConstant},
      std::pair{"cosine", bulletnav::bench::Schedule::kCosine}};
};
template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Device> {
  static constexpr std::array kNames = {std::pair{"cpu", bulletnav::bench::Device::kCpu},
                                        std::pair{"cuda", bulletnav::bench::Device::kCuda}};
};

namespace bulletnav::bench {

/// Adam. Source: Kingma and Ba, 2014; the rate is of Neural Topological SLAM, appendix A.
struct OptimiserSpec {
  double learning_rate = 5e-4;
  Schedule schedule = Schedule::kCosine;
  int warmup_steps = 200;     // the rate rises to its full height over these
  double weight_decay = 0.0;  // of weights, not of their gradients
  double epsilon = 1e-8;      // is added to the deviation of gradients that a step is divided by

  /// The rate of step 0, 1, ... of `steps`, warming up from step `begin`, which is not after it.
  double RateAt(int step, int steps, int begin = 0) const;

  template <class V>
  void Visit(V& v) {
    v("learning_rate", learning_rate);
    v("schedule", schedule);
    v("warmup_steps", warmup_steps);
    v("weight_decay", weight_decay);
    v("epsilon", epsilon);
  }
  /// Throws Error.
  void Validate() const;
};

/// What every training is told. A task's Config derives from it, and its Visit and Validate call
/// these or list the same keys.
struct TrainPlan {
  std::optional<std::string> task;  // name of the trainer
  std::string out;                  // folder of all that the training writes
  OptimiserSpec optimiser;
  int steps = 20000;
  int validate_every = 500;  // steps; a checkpoint is written then, too
  std::uint64_t seed = 0;
  std::optional<Device> device;  // default: cpu

  template <class V>
  void Visit(V& v) {
    v("task", task);
    v.Required("out", out);
    v("optimiser", optimiser);
    v("steps", steps);
    v("validate_every", validate_every);
    v("seed", seed);
    v("device", device);
  }
  /// Throws Error.
  void Validate() const;
  /// Whether what is learned in a step depends on how many steps there are. A task's plan may say
  /// that it does not: then a training can be made longer in its folder, by more `steps`.
  bool heeds_steps() const { return true; }
  /// Whether it can be trained on devices other than kCpu. A task's plan may say that it cannot.
  bool heeds_device() const { return true; }
};

namespace internal {

/// Throws Error.
void RequireAtLeast(int low, int value, const std::string& name);

}  // namespace internal

}  // namespace bulletnav::bench
