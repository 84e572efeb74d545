// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/data_config.h"

#include <set>

#include "agent/mapping/map_spec.h"
#include "benchmark/episodes/generator.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::Error;

constexpr int kMostPoints = 2000;  // 64 MB of labels a scene

}  // namespace

void DataHouses::Validate() const {
  if (count < 0 || count > 9999) {
    throw sim::KeyError("count", "count must lie between 0 and 9999");
  }
  if (count > 0 && fs::path(index).filename() != "index.json") {
    throw sim::KeyError("index", "houses are generated with an index.json; name that");
  }
}

void DataConfig::Validate() const {
  if (scenes.empty() && !houses && !more_houses) {
    throw Error("names no scenes; give 'scenes', 'houses' or 'more_houses'");
  }
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

void MakeHousesOf(const DataConfig& config, const std::string& made_by, int workers,
                  const StartProgress& start) {
  if (config.houses && config.houses->count > 0 && !fs::exists(config.houses->index)) {
    const fs::path folder = fs::path(config.houses->index).parent_path();
    MakeHouses({folder.empty() ? "." : folder.string(), config.houses->count}, made_by, workers,
               start);
  }
  if (config.more_houses) MakeHouses(*config.more_houses, made_by, workers, start);
}

std::vector<fs::path> ScenesOf(const DataConfig& config) {
  GeneratorSpec spec;
  spec.scenes = config.scenes;
  if (config.houses) spec.houses = HouseSelection{config.houses->index, config.houses->split};
  const std::vector<std::string> files = ScenesOf(spec);
  std::vector<fs::path> scenes(files.begin(), files.end());
  if (config.more_houses) {
    const std::vector<fs::path> more = FilesOf(*config.more_houses);
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  std::set<fs::path> known;
  for (const fs::path& scene : scenes) {
    if (known.insert(fs::absolute(scene).lexically_normal()).second) continue;
    throw sim::FileError(scene, "", "is named twice; name each scene once");
  }
  return scenes;
}

std::uint64_t LabelsKey(const DataConfig& config) {
  DataConfig relevant = config;
  relevant.scenes.clear();
  relevant.houses.reset();
  relevant.more_houses.reset();
  relevant.looks.reset();  // labels are of the scene, not of its look
  relevant.cache.clear();
  return sim::Hash64(sim::ToYaml(relevant));
}

}  // namespace bulletnav::bench
