// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "agent/perception/mapper_config.h"
#include "agent/perception/model_config.h"
#include "benchmark/training/augment.h"
#include "benchmark/training/data_config.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// kCosine: falls to zero at the last step.
enum class Schedule { kConstant, kCosine };
/// What is trained: the functions of Neural Topological SLAM, or the mapper for colour alone.
enum class Trained { kNts, kMapper };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Schedule> {
  static constexpr std::array kNames = {
      std::pair{"constant", bulletnav::bench::Schedule::kConstant},
      std::pair{"cosine", bulletnav::bench::Schedule::kCosine}};
};
template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Trained> {
  static constexpr std::array kNames = {std::pair{"nts", bulletnav::bench::Trained::kNts},
                                        std::pair{"mapper", bulletnav::bench::Trained::kMapper}};
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

/// What all trainings are told.
struct TrainPlan {
  std::optional<Trained> task;           // default: nts
  std::string out;                       // folder of all that the training writes
  std::optional<DataConfig> data;        // what SceneBatches learns from
  std::optional<DataConfig> validation;  // and is tried on; default: the houses' split "val"
  OptimiserSpec optimiser;
  AugmentSpec augment;
  int steps = 20000;
  int scenes = 4;      // batches a step
  int lanes = 2;       // that share them; each normalises by its own batches
  int panoramas = 16;  // in each batch
  /// Share of the batches whose panoramas are near one another: pairs that are easily mistaken for
  /// one node. Default: none, panoramas are from anywhere in the scene.
  std::optional<double> near_batches;
  int validate_every = 500;  // steps; a checkpoint is written then, too
  int validation_batches = 32;
  std::uint64_t seed = 0;

  /// Throws Error.
  void Validate() const;

 protected:
  template <class V>
  void VisitData(V& v) {
    v("task", task);
    v.Required("out", out);
    v("data", data);
    v("validation", validation);
  }
  template <class V>
  void VisitSteps(V& v) {
    v("optimiser", optimiser);
    v("augment", augment);
    v("steps", steps);
    v("scenes", scenes);
    v("lanes", lanes);
    v("panoramas", panoramas);
    v("near_batches", near_batches);
  }
  template <class V>
  void VisitValidation(V& v) {
    v("validate_every", validate_every);
    v("validation_batches", validation_batches);
    v("seed", seed);
  }
};

/// Scores' differences between the directions of a panorama, learned besides the scores themselves:
/// the choice of a direction hangs on them, but they are small beside what panoramas differ by.
struct ScoreContrast {
  double weight = 0.0;
  int from_step = 0;

  template <class V>
  void Visit(V& v) {
    v.Required("weight", weight);
    v("from_step", from_step);
  }
  /// Throws Error.
  void Validate() const;
};

/// A training of the learned model of Neural Topological SLAM.
struct TrainConfig : TrainPlan {
  agent::ModelConfig model;
  int pairs = 64;  // compared of each batch, half of them of one node if there are enough
  std::optional<ScoreContrast> score_contrast;  // default: none, as in the paper
  /// Weight of what the distance says of pairs of two nodes, which is to be 3 m or more: a second
  /// opinion where F_L takes one room for another. Default: none.
  std::optional<double> rejection;

  template <class V>
  void Visit(V& v) {
    VisitData(v);
    v("model", model);
    VisitSteps(v);
    v("pairs", pairs);
    v("score_contrast", score_contrast);
    v("rejection", rejection);
    VisitValidation(v);
  }
  /// Throws Error.
  void Validate() const;
};

/// A training of the mapper from colour.
struct MapperTrainConfig : TrainPlan {
  agent::MapperConfig model;
  double obstacle_weight = 3.0;  // of cells with an obstacle against those without

  MapperTrainConfig() { task = Trained::kMapper; }

  template <class V>
  void Visit(V& v) {
    VisitData(v);
    v("model", model);
    VisitSteps(v);
    v("obstacle_weight", obstacle_weight);
    VisitValidation(v);
  }
  /// Throws Error.
  void Validate() const;
};

/// What a file trains, by its key "task". Throws FileError.
Trained TrainedBy(const std::filesystem::path& file);

/// `validation`, or its default. Throws Error if there is neither.
DataConfig ValidationData(const TrainPlan& plan);

}  // namespace bulletnav::bench
