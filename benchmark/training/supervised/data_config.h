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
#include "benchmark/training/core/training_scenes.h"
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

/// What supervised data are made from: the block `data` of a training's config.
/// Default: 300 points per scene. Source: Neural Topological SLAM, section 5.
struct DataConfig : TrainingScenes {
  ImportSpec import;               // of all scenes
  std::optional<LooksSpec> looks;  // of all scenes; absent: as their files say
  int points = 300;                // a scene; all ordered pairs of them are labelled
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
    TrainingScenes::Visit(v);
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

/// A hash of all that the labels of a scene depend on besides the scene; not of which scenes there
/// are or where the labels lie.
std::uint64_t LabelsKey(const DataConfig& config);

}  // namespace bulletnav::bench
