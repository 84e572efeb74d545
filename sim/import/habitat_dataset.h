// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "sim/config/json_node.h"

namespace bulletnav::sim {

/// What a stage or an object of a data set is made from.
struct HabitatTemplate {
  std::string name;             // its file's, without extensions
  std::filesystem::path asset;  // the mesh to draw, of articulated objects the URDF
  /// From the asset's own axes and units to Habitat's (up +y, front -z) in metres; of articulated
  /// objects a scale.
  Eigen::Matrix3f turn_and_scale = Eigen::Matrix3f::Identity();
  std::optional<Eigen::Vector3f> center_of_mass;  // in the asset's axes turned, metres
};

/// A list of three numbers. Throws FileError for anything else.
Eigen::Vector3f ReadVector(const JsonNode<nlohmann::ordered_json>& node);

/// The data set that a *.scene_instance.json is of: the first *.scene_dataset_config.json, from the
/// scene's folder upwards and in the order of names, whose `scene_instances.paths` list the scene.
/// Its paths may hold * and ?; names of templates are found by file name, by the end of the path,
/// then by a part of the file name that only one has.
/// Source of the format: habitat-sim's documentation, "Using JSON files to configure attributes".
class HabitatDataset {
 public:
  enum class Kind { kStage, kObject, kArticulated };

  /// Throws FileError: no such file, or bad content of one.
  explicit HabitatDataset(const std::filesystem::path& scene);

  /// Throws Error with what to do: no template has that name, or several have; FileError for a bad
  /// template.
  HabitatTemplate Find(Kind kind, const std::string& name) const;

  const std::filesystem::path& file() const { return file_; }

 private:
  using Json = nlohmann::ordered_json;
  struct Entry {
    std::string handle;          // its path without extensions
    std::filesystem::path file;  // of its attributes, or the asset itself, or empty
    bool is_asset = false;
    Json overrides;  // by the data set
  };

  bool Lists(const std::filesystem::path& scene) const;
  std::vector<Entry> EntriesOf(Kind kind) const;
  void AddConfigs(const Json& configs, Kind kind, std::vector<Entry>* entries) const;
  HabitatTemplate Load(Kind kind, const Entry& entry) const;
  const std::vector<Entry>& entries(Kind kind) const;

  std::filesystem::path file_;
  Json json_;
  std::vector<Entry> stages_;
  std::vector<Entry> objects_;
  std::vector<Entry> articulated_;
};

}  // namespace bulletnav::sim
