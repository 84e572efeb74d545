// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/training/measures.h"
#include "benchmark/training/train_config.h"
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
  std::string title;  // what is trained, for people
  TrainPlan plan;
  std::string config;   // all that the user said, as YAML
  std::string essence;  // the same without the folder: what the result follows from
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
