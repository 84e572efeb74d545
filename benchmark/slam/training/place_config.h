// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "agent/slam/descriptors/descriptor_config.h"
#include "benchmark/episodes/import_spec.h"
#include "benchmark/training/core/train_plan.h"
#include "benchmark/training/core/training_scenes.h"
#include "benchmark/training/supervised/color_jitter.h"
#include "benchmark/training/supervised/looks.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/body_spec.h"
#include "sim/render/projection.h"

namespace bulletnav::bench {

/// Pictures of places of which a descriptor is learned: the block `data` of a training of places.
struct PlaceDataConfig : TrainingScenes {
  ImportSpec import;               // of all scenes
  std::optional<LooksSpec> looks;  // of every second view of a place; absent: as their files say
  int places = 40;                 // a scene
  int views = 4;                   // a place
  std::uint64_t seed = 0;
  sim::BodySpec body;
  sim::NavmeshSpec navmesh;
  sim::PinholeSpec camera = {.rows = 240, .cols = 320};
  std::string cache = "data/places";  // folder of the views, one file per scene

  template <class V>
  void Visit(V& v) {
    TrainingScenes::Visit(v);
    v("import", import);
    v("looks", looks);
    v("places", places);
    v("views", views);
    v("seed", seed);
    v("body", body);
    v("navmesh", navmesh);
    v("camera", camera);
    v("cache", cache);
  }
  void Validate() const;
};

/// A hash of all that the views of a scene depend on besides the scene.
std::uint64_t ViewsKey(const PlaceDataConfig& config);

/// Multi-similarity loss over the views of a batch. Source: Wang et al., "Multi-similarity loss
/// with general pair weighting for deep metric learning", CVPR 2019; settings of Ali-bey,
/// Chaib-draa and Giguere, "GSV-Cities", 2022.
struct SimilarityLossSpec {
  double alpha = 1.0;   // of positives
  double beta = 50.0;   // of negatives
  double base = 0.0;    // cosine that both are compared with
  double margin = 0.1;  // pairs easier than the hardest of the other kind by this do not count

  template <class V>
  void Visit(V& v) {
    v("alpha", alpha);
    v("beta", beta);
    v("base", base);
    v("margin", margin);
  }
  void Validate() const;
};

/// How a batch's pictures are varied, each by itself but for mirroring.
struct PictureAugmentSpec {
  double mirrored = 0.5;    // share of the batches whose pictures are all mirrored
  double brightness = 0.3;  // as in ColorJitter, like the next two
  double contrast = 0.2;
  double tint = 0.1;
  /// Share of the pictures with a camera's noise, of any named model, at a strength up to
  /// `noise_strength`.
  double sensor_noise = 0.3;
  double noise_strength = 1.5;

  template <class V>
  void Visit(V& v) {
    v("mirrored", mirrored);
    v("brightness", brightness);
    v("contrast", contrast);
    v("tint", tint);
    v("sensor_noise", sensor_noise);
    v("noise_strength", noise_strength);
  }
  ColorJitter color() const { return {brightness, contrast, tint}; }
  /// Throws Error.
  void Validate() const;
};

/// A training of the descriptor of flat pictures.
struct PlaceTrainConfig : TrainPlan {
  std::optional<PlaceDataConfig> data;
  std::optional<PlaceDataConfig> validation;  // default: the houses' split "val"
  agent::DescriptorConfig model;
  /// Weights of a semantic model of colour whose trunk the training starts from, or of a descriptor
  /// that it goes on from; empty: at random.
  std::string start_from;
  SimilarityLossSpec loss;
  std::optional<PictureAugmentSpec> augment;  // absent: pictures as they were drawn
  int places = 16;                            // in a batch
  int scenes = 2;  // that they are from: most that are unlike are of the same house
  int lanes = 2;   // batches a step, each in a thread
  int validation_scenes = 8;

  PlaceTrainConfig() { task = "place"; }

  template <class V>
  void Visit(V& v) {
    v("task", task);
    v.Required("out", out);
    v("data", data);
    v("validation", validation);
    v("model", model);
    v("start_from", start_from);
    v("optimiser", optimiser);
    v("steps", steps);
    v("loss", loss);
    v("augment", augment);
    v("places", places);
    v("scenes", scenes);
    v("lanes", lanes);
    v("validate_every", validate_every);
    v("validation_scenes", validation_scenes);
    v("seed", seed);
    v("device", device);
  }
  /// Throws Error.
  void Validate() const;
};

/// `validation`, or its default. Throws Error if there is neither.
PlaceDataConfig ValidationData(const PlaceTrainConfig& config);

}  // namespace bulletnav::bench
