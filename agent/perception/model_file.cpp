// SPDX-License-Identifier: MIT
#include "agent/perception/model_file.h"

#include <string>

#include "agent/models/config_in_weights.h"

namespace bulletnav::agent {
ModelConfig ModelConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<ModelConfig>(weights, kModelKey, file, "a model; train it again");
}

MapperConfig MapperConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<MapperConfig>(weights, kMapperKey, file, "a mapper; train it again");
}

sim::FileError OtherShape(const std::filesystem::path& file, const std::string& key) {
  return {file, key,
          "is of another shape than the net to train; `bulletnav weights` shows it: give the "
          "config's block 'model' the same"};
}

void RequireRig(const Rig& rig, const ModelConfig& config, const std::filesystem::path& file) {
  const std::string model = "the model of " + file.string() + " takes ";
  if (rig.panorama.rows != kPanoramaRows || rig.panorama.cols != kPanoramaCols) {
    throw sim::Error(model + "panoramas of 128 x 512; set the panorama's rows and cols so");
  }
  if (!rig.has_color) {
    throw sim::Error(model + "a panorama's colour, which the setting lacks; use rgb or rgbd");
  }
  if (config.uses_depth() && !rig.has_depth) {
    throw sim::Error(model + "depth; use weights of the rgb setting, or the setting rgbd");
  }
}

}  // namespace bulletnav::agent
