// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/training/core/measures.h"
#include "benchmark/training/core/train_plan.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {

class Learner;

/// A line of the picture of a training's curves.
struct CurveLine {
  std::string title;
  std::string measure;
};

/// A training of one kind of model, for the trainer of all.
struct TrainTask {
  std::string name;   // as it is registered
  std::string title;  // what is trained, for people
  TrainPlan plan;
  int batches = 1;                    // that a step learns from; a multiple of the plan's lanes
  std::int64_t frames = 0;            // panoramas or steps of bodies that these hold
  std::string frames_are = "frames";  // in words
  std::string data;                   // where they come from, for people
  std::string validation;             // what it is tried on, for people
  std::string config;                 // all that the user said, as YAML
  std::string essence;                // the same without the folder: what the result follows from
  std::function<std::unique_ptr<Learner>()> make;        // always the same net
  std::function<std::string(const Measures&)> describe;  // a validation, in a line
  std::string curves_label;                              // of the picture's y axis
  std::vector<CurveLine> curves;

  template <class Config>
  static TrainTask Of(Config config) {
    TrainTask task;
    task.plan = config;
    task.config = sim::ToYaml(config);
    config.out.clear();
    task.essence = sim::ToYaml(config);
    return task;
  }
};

}  // namespace bulletnav::bench
