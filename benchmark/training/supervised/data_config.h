// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/episodes/import_spec.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/training/supervised/looks.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/body_spec.h"
#include "sim/render/projection.h"

namespace bulletnav::bench {

/// Whether the ways that decide if a direction is explorable may lead over floor that the source
/// cannot see, behind a door's jamb or furniture. kFree is the paper's, whose map is of obstacles,
/// except for what is deep behind furniture; see NearMap.
enum class HiddenFloor { kFree, kBlocked };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::HiddenFloor> {
  static constexpr std::array kNames = {
      std::pair{"free", bulletnav::bench::HiddenFloor::kFree},
      std::pair{"blocked", bulletnav::bench::HiddenFloor::kBlocked}};
};

namespace bulletnav::bench {

/// The houses of one split of an index that the house generator wrote.
struct DataHouses {
  std::string index;
  std::string split = "train";
  int count = 0;  // so many are generated, from seed 0 on, if there is no index; 0: none

  template <class V>
  void Visit(V& v) {
    v.Required("index", index);
    v("split", split);
    v("count", count);
  }
  void Validate() const;
};

/// What supervised data are made from: the block `data` of a training's config.
/// Default: 300 points per scene. Source: Neural Topological SLAM, section 5.
struct DataConfig {
  std::vector<std::string> scenes;        // mesh files
  std::optional<DataHouses> houses;       // in addition
  std::optional<HousesSpec> more_houses;  // in addition, all of them; made if they are not there
  ImportSpec import;                      // of all scenes
  std::optional<LooksSpec> looks;         // of all scenes; absent: as their files say
  int points = 300;                       // a scene; all ordered pairs of them are labelled
  std::uint64_t seed = 0;
  HiddenFloor hidden = HiddenFloor::kFree;
  /// Metres that the nearest free floor may lie beside the point 3 m away in a direction, for those
  /// that end in a wall just behind a doorway. 0: the paper's rule.
  double target_slack = 0.0;
  sim::BodySpec body;
  sim::NavmeshSpec navmesh;
  sim::PanoramaSpec panorama;
  std::string cache = "data/training";  // folder of the labels, one file per scene

  template <class V>
  void Visit(V& v) {
    v("scenes", scenes);
    v("houses", houses);
    v("more_houses", more_houses);
    v("import", import);
    v("looks", looks);
    v("points", points);
    v("seed", seed);
    v("hidden", hidden);
    v("target_slack", target_slack);
    v("body", body);
    v("navmesh", navmesh);
    v("panorama", panorama);
    v("cache", cache);
  }
  void Validate() const;
};

/// Reads the block `data` of a file and nothing else of it, so that a training's config will do.
/// Throws sim::FileError at file:line:column.
DataConfig LoadDataConfig(const std::filesystem::path& file);

/// Generates the houses of a config that it says how to make and that are not there yet; see
/// MakeHouses.
void MakeHousesOf(const DataConfig& config, const std::string& made_by, int workers,
                  const StartProgress& start);

/// The mesh files that a config names: scenes, houses, more houses. Throws sim::Error for an index
/// that is missing, damaged or has no house in the split.
std::vector<std::filesystem::path> ScenesOf(const DataConfig& config);

/// A hash of all that the labels of a scene depend on besides the scene; not of which scenes there
/// are or where the labels lie.
std::uint64_t LabelsKey(const DataConfig& config);

}  // namespace bulletnav::bench
