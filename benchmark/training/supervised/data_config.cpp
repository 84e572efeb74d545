// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/data_config.h"

#include "agent/mapping/map_spec.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::Error;

constexpr int kMostPoints = 2000;  // 64 MB of labels a scene

}  // namespace

void DataConfig::Validate() const {
  TrainingScenes::Validate();
  if (points < 1 || points > kMostPoints) throw Error("points must lie between 1 and 2000");
  if (cache.empty()) throw Error("'cache' is empty; name a folder for the labels");
  if (!(target_slack >= 0.0 && target_slack <= 0.5)) {
    throw Error("target_slack must lie between 0 and 0.5 m");
  }
  body.Validate();
  navmesh.Validate();
  panorama.Validate();
  if (!(double{panorama.max_depth_m} >= agent::MapSpec{}.vision)) {
    throw Error("the panorama's max_depth_m must be at least 3.2, as far as labels look");
  }
}

DataConfig LoadDataConfig(const fs::path& file) {
  const sim::YamlNode root = sim::ParseYaml(sim::ReadYamlFile(file), file);
  root.ExpectMap();
  const YAML::Node& map = root.yaml();
  if (!map["data"]) root.Fail("key 'data' is missing");
  DataConfig config;
  sim::YamlReader::Read(root.Child(map["data"]), config);
  return config;
}

std::uint64_t LabelsKey(const DataConfig& config) {
  DataConfig relevant = config;
  static_cast<TrainingScenes&>(relevant) = {};
  relevant.looks.reset();  // labels are of the scene, not of its look
  relevant.cache.clear();
  return sim::Hash64(sim::ToYaml(relevant));
}

}  // namespace bulletnav::bench
