// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_config.h"

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

void RequireWithin(int low, int value, int high, const std::string& key) {
  if (value >= low && value <= high) return;
  throw sim::KeyError(
      key, key + " must lie between " + std::to_string(low) + " and " + std::to_string(high));
}

}  // namespace

void PlaceDataConfig::Validate() const {
  TrainingScenes::Validate();
  RequireWithin(2, places, 1000, "places");
  RequireWithin(2, views, 16, "views");
  body.Validate();
  navmesh.Validate();
  camera.Validate();
  if (camera.pitch_deg != 0.0) throw sim::KeyError("camera", "the camera must be level");
  if (cache.empty()) throw sim::KeyError("cache", "'cache' is empty; name a folder for the views");
}

std::uint64_t ViewsKey(const PlaceDataConfig& config) {
  PlaceDataConfig relevant = config;
  static_cast<TrainingScenes&>(relevant) = {};
  relevant.cache.clear();
  return sim::Hash64(sim::ToYaml(relevant));
}

void SimilarityLossSpec::Validate() const {
  if (!(alpha > 0.0 && beta > 0.0)) throw sim::Error("alpha and beta must be positive");
  if (!(margin >= 0.0 && margin <= 2.0)) throw sim::Error("margin must lie between 0 and 2");
}

void PictureAugmentSpec::Validate() const {
  color().Validate();
  RequireSensorNoise(sensor_noise, noise_strength);
  if (!(mirrored >= 0.0 && mirrored <= 1.0)) {
    throw sim::KeyError("mirrored", "is a share, 0 to 1");
  }
}

void PlaceTrainConfig::Validate() const {
  TrainPlan::Validate();
  RequireWithin(2, places, 256, "places");
  RequireWithin(1, scenes, places, "scenes");
  RequireWithin(1, lanes, 64, "lanes");
  RequireWithin(1, validation_scenes, 10000, "validation_scenes");
  if (places % scenes != 0) {
    throw sim::KeyError("places", "places must be a multiple of scenes");
  }
  if (data && data->places < places / scenes) {
    throw sim::KeyError("data", "has fewer places a scene than a batch takes of one");
  }
  if (data && !validation && !data->houses) {
    throw sim::KeyError("data",
                        "names no 'houses' whose split 'val' would serve to validate; add a "
                        "block 'validation'");
  }
}

PlaceDataConfig ValidationData(const PlaceTrainConfig& config) {
  if (config.validation) return *config.validation;
  if (!config.data || !config.data->houses) {
    throw sim::KeyError("data", "there is no block 'data'; see configs/train/place.yaml");
  }
  PlaceDataConfig validation = *config.data;
  validation.scenes.clear();
  validation.more_houses.reset();
  validation.houses->split = "val";
  return validation;
}

}  // namespace bulletnav::bench
