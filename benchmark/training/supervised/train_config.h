// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "agent/perception/mapper_config.h"
#include "agent/perception/model_config.h"
#include "benchmark/training/core/train_plan.h"
#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/data_config.h"

namespace bulletnav::bench {

/// What all trainings from labelled panoramas are told.
struct SupervisedPlan : TrainPlan {
  std::optional<std::string> start;      // weights to go on from; default: none
  std::optional<DataConfig> data;        // what SceneBatches learns from
  std::optional<DataConfig> validation;  // and is tried on; default: the houses' split "val"
  AugmentSpec augment;
  int scenes = 4;      // batches a step
  int lanes = 2;       // that share them; each normalises by its own batches
  int panoramas = 16;  // in each batch
  /// Share of the batches whose panoramas are near one another: pairs that are easily mistaken for
  /// one node. Default: none, panoramas are from anywhere in the scene.
  std::optional<double> near_batches;
  int validation_batches = 32;

  /// Panoramas shown in a step.
  int frames() const { return scenes * panoramas; }

  /// Throws Error.
  void Validate() const;

 protected:
  template <class V>
  void VisitData(V& v) {
    v("task", task);
    v.Required("out", out);
    v("start", start);
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
    v("device", device);
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
struct TrainConfig : SupervisedPlan {
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
struct MapperTrainConfig : SupervisedPlan {
  agent::MapperConfig model;
  double obstacle_weight = 3.0;  // of cells with an obstacle against those without

  MapperTrainConfig() { task = "mapper"; }

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

/// `validation`, or its default. Throws Error if there is neither.
DataConfig ValidationData(const SupervisedPlan& plan);

}  // namespace bulletnav::bench
