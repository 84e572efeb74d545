// SPDX-License-Identifier: MIT
#include "agent/perception/model_file.h"

#include <string>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {
namespace {

template <class Config>
Config ConfigOf(const TensorFile& weights, const char* key, const std::filesystem::path& file) {
  const auto found = weights.metadata.find(key);
  if (found == weights.metadata.end()) {
    throw sim::FileError(file, "",
                         std::string("does not hold the weights of a ") + key + "; train it again");
  }
  return sim::LoadYamlText<Config>(found->second, file);
}

}  // namespace

ModelConfig ModelConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigOf<ModelConfig>(weights, kModelKey, file);
}

MapperConfig MapperConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigOf<MapperConfig>(weights, kMapperKey, file);
}

void RequireRig(const Rig& rig, const ModelConfig& config, const std::filesystem::path& file) {
  const std::string model = "the model of " + file.string() + " takes ";
  if (rig.panorama.rows != kPanoramaRows || rig.panorama.cols != kPanoramaCols) {
    throw sim::Error(model + "panoramas of 128 x 512; set the panorama's rows and cols so");
  }
  if (!rig.has_color) throw sim::Error(model + "colour, but the setting gives none");
  if (config.uses_depth() && !rig.has_depth) {
    throw sim::Error(model + "depth; use weights of the rgb setting, or the setting rgbd");
  }
}

}  // namespace bulletnav::agent
