// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_config.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/core.h>

#include "benchmark/episodes/generator.h"
#include "sim/base/error.h"
#include "sim/config/override.h"
#include "sim/house/house_index.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Of metres and degrees: information is one over their squares.
constexpr double kLeastDeviation = 1e-6;
constexpr double kMostDeviation = 1e6;

/// What results call files of a drive.
const std::set<std::string>& TakenNames() {
  static const std::set<std::string> names = {"odometry",    "groundtruth", "covisible", "result",
                                              "times",       "rgb",         "depth",     "poses",
                                              "calibration", "calib",       "config"};
  return names;
}

/// Rows' names are files, too, and cells of tables.
bool IsFileName(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  return !name.empty() && name.size() <= kLongest && name.front() != '.' && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
         });
}

/// Fills in names, and defaults of parameters, which complain at their place in the file.
void Complete(const sim::YamlNode& root, const fs::path& file, SlamConfig* config) {
  if (config->name.empty()) config->name = file.stem().string();
  if (config->name.find('/') != std::string::npos || config->name.front() == '.') {
    root.FailAt("name", "'" + config->name +
                            "' cannot name a folder of results; leave '/' and a dot in front out");
  }
  std::set<std::string> names;
  const YAML::Node entries = root.yaml()["detectors"];
  for (std::size_t i = 0; i < config->detectors.size(); ++i) {
    DetectorEntry& entry = config->detectors[i];
    const sim::YamlNode place = root.Child(entries[i]);
    const sim::YamlNode detector = root.Child(entries[i]["detector"]);
    const std::string resolved = agent::ResolveLoopConfig(detector, entry.parameters);
    entry.parameters.emplace(root.Child(YAML::Load(resolved)));
    if (entry.name.empty()) entry.name = entry.detector;
    if (!IsFileName(entry.name) || TakenNames().count(entry.name) > 0) {
      place.Fail("'" + entry.name +
                 "' cannot name a detector's files; take at most 64 letters, digits, '_', '-' and "
                 "'.', and no name of another file, as 'odometry'");
    }
    if (!names.insert(entry.name).second) {
      place.Fail("two detectors are called '" + entry.name + "'; give one a 'name'");
    }
  }
  if (!config->against.empty() && names.count(config->against) == 0) {
    root.FailAt("against", "no detector is called '" + config->against + "'; see 'detectors'");
  }
}

std::vector<fs::path> ScenesOf(const SlamConfig& config) {
  std::vector<fs::path> scenes;
  if (config.houses) {
    const fs::path folder = config.houses->folder;
    FilesOf(*config.houses);  // that they are there
    for (const sim::HouseEntry& house : sim::ReadHouseIndex(folder / "index.json")) {
      if (!config.split || house.split == *config.split) scenes.push_back(folder / house.file);
    }
    if (config.first_houses) {
      scenes.resize(std::min(scenes.size(), static_cast<std::size_t>(*config.first_houses)));
    }
  }
  GeneratorSpec named;
  named.scenes = config.scenes;
  for (const std::string& scene : ScenesOf(named)) {
    if (!fs::exists(scene)) throw sim::FileError(scene, "", "is not there; see 'scenes'");
    scenes.emplace_back(scene);
  }
  return scenes;
}

}  // namespace

void VocabularySource::Validate() const {
  if (actions < 1 || every < 1) throw sim::Error("expected actions and every of at least 1");
}

void ChangeSpec::Validate() const {
  if (!(from >= 0.0 && from <= 1.0)) throw sim::KeyError("from", "from must lie between 0 and 1");
  if (!finish && !houses) throw sim::Error("nothing changes; name a 'finish', 'houses' or both");
}

void BackEndSpec::Validate() const {
  for (const double deviation : {step_m, step_deg, loop_m, loop_deg, width}) {
    if (deviation >= kLeastDeviation && deviation <= kMostDeviation) continue;
    throw sim::Error("step_m, step_deg, loop_m, loop_deg and width must lie between 1e-6 and 1e6");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw sim::KeyError("confidence", "confidence must lie between 0 and 1");
  }
  if (!(odometry_confidence >= 0.0 && odometry_confidence < 1.0)) {
    throw sim::KeyError("odometry_confidence",
                        "odometry_confidence must be at least 0 and below 1");
  }
  if (runs < 1 || run_gap < 0 || !(most_error >= 0.0 && drift_deg >= 0.0)) {
    throw sim::Error("expected runs of at least 1; run_gap, most_error, drift_deg of at least 0");
  }
  if (!(lone_chance >= 0.0 && lone_chance <= 1.0)) {
    throw sim::KeyError("lone_chance", "lone_chance must lie between 0 and 1");
  }
}

void SlamConfig::Validate() const {
  sim::RequireSensorNoise(sensor_noise.value_or("none"));
  if (detectors.empty()) throw sim::KeyError("detectors", "'detectors' has no entry");
  if (first_houses.value_or(1) < 1) {
    throw sim::KeyError("first_houses", "'first_houses' must be at least 1");
  }
  if (actions.empty()) throw sim::KeyError("actions", "'actions' has no number");
  for (const int count : actions) {
    if (count < 1) throw sim::KeyError("actions", "'actions' must be at least 1");
  }
  if (seeds.empty()) throw sim::KeyError("seeds", "'seeds' has no number");
  for (const auto& [key, file] :
       {std::pair{"descriptors", descriptors}, {"sequences", sequences}, {"filter", filter}}) {
    if (file && file->empty())
      throw sim::KeyError(key, std::string(key) + " is empty; name a file of weights");
  }
  if (sequences && !descriptors) {
    throw sim::KeyError("sequences", "'sequences' needs 'descriptors', the network that it is of");
  }
  if (filter && !descriptors) {
    throw sim::KeyError("filter", "'filter' needs 'descriptors', the network that it is of");
  }
  if (panorama && panorama->projection != sim::Projection::kCylindrical) {
    throw sim::KeyError("panorama", "'panorama' must be cylindrical");
  }
  if (panorama && (sequences || filter)) {
    throw sim::KeyError(sequences ? "sequences" : "filter",
                        "is trained on flat pictures; leave it or 'panorama' out");
  }
  if (panorama && !recordings.empty()) {
    throw sim::KeyError("panorama", "recordings are of flat pictures; leave one of the two out");
  }
  if (places && !panorama) {
    throw sim::KeyError("places", "'places' needs 'panorama': {} for the task's own");
  }
  if (!(apart_m > 0.0)) throw sim::KeyError("apart_m", "apart_m must be positive");
  if (camera.pitch_deg != 0.0)
    throw sim::KeyError("camera", "the camera must be level: pitch_deg 0");
}

SlamConfig LoadSlamConfig(const fs::path& file, std::span<const std::string> overrides) {
  const sim::YamlNode root = sim::ReadWithOverrides(file, overrides);
  SlamConfig config;
  sim::YamlReader::Read(root, config);
  Complete(root, file, &config);
  return config;
}

namespace {

/// A scene's file name, after that of its folder where another scene's file is called the same.
std::string NameIn(const std::vector<fs::path>& scenes, const fs::path& scene) {
  const auto same = std::count_if(scenes.begin(), scenes.end(), [&](const fs::path& other) {
    return other.stem() == scene.stem();
  });
  const std::string stem = scene.stem().string();
  const std::string folder = fs::absolute(scene).parent_path().filename().string();
  return same > 1 && !folder.empty() ? folder + "_" + stem : stem;
}

void AddDrives(const std::string& name, const fs::path& scene, const SlamConfig& config,
               std::vector<Drive>* drives) {
  for (const int actions : config.actions) {
    for (const std::uint64_t seed : config.seeds) {
      drives->push_back(
          {fmt::format("{}_{}_{}", name, actions, seed), scene, false, actions, seed, name});
    }
  }
}

std::vector<Drive> SceneDrives(const SlamConfig& config) {
  const std::vector<fs::path> scenes = ScenesOf(config);
  std::vector<Drive> drives;
  for (const fs::path& scene : scenes) AddDrives(NameIn(scenes, scene), scene, config, &drives);
  return drives;
}

Drive RecordingOf(const std::string& recording) {
  if (!fs::exists(recording)) {
    throw sim::FileError(recording, "", "is not there; see 'recordings'");
  }
  if (!fs::exists(fs::path(recording) / "rgb.txt")) {
    throw sim::FileError(recording, "",
                         "is no recording of slam run's: rgb.txt is not there; bring a TUM folder "
                         "or a sequence of KITTI's in with ./bulletnav slam import FOLDER --out "
                         "RECORDING, and name that in 'recordings'");
  }
  const fs::path folder = fs::path(recording).lexically_normal();
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  const std::string name = named.filename().string();
  return {name, recording, true, 0, 0, name};
}

void CheckNames(const std::vector<Drive>& drives) {
  std::set<std::string> names;
  for (const Drive& drive : drives) {
    if (names.insert(drive.name).second) continue;
    throw sim::Error("two drives are called '" + drive.name +
                     "'; give their scenes or recordings different names");
  }
}

}  // namespace

std::vector<Drive> DrivesOf(const SlamConfig& config) {
  std::vector<Drive> drives = SceneDrives(config);
  for (const std::string& recording : config.recordings) drives.push_back(RecordingOf(recording));
  if (drives.empty()) {
    throw sim::Error(config.houses && config.split
                         ? "no house of 'houses' is of the split '" +
                               std::string(sim::NameOf(*config.split)) +
                               "'; set 'split' or 'houses.count'"
                         : "there is nothing to drive through; name 'houses', 'scenes' "
                           "or 'recordings'");
  }
  CheckNames(drives);
  return drives;
}

}  // namespace bulletnav::bench
