// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/made_houses.h"

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

/// The scenes that a training, or a trial of what was trained, is given: the first keys of a
/// config's block `data`.
struct TrainingScenes {
  std::vector<std::string> scenes;        // mesh files
  std::optional<DataHouses> houses;       // in addition
  std::optional<HousesSpec> more_houses;  // in addition, all of them; made if they are not there

  template <class V>
  void Visit(V& v) {
    v("scenes", scenes);
    v("houses", houses);
    v("more_houses", more_houses);
  }
  /// Throws Error if none is named.
  void Validate() const;
};

/// Generates the houses that it says how to make and that are not there yet; see MakeHouses.
void MakeHousesOf(const TrainingScenes& scenes, const std::string& made_by, int workers,
                  const StartProgress& start);

/// The mesh files that it names: scenes, houses, more houses. Throws sim::Error for an index that
/// is missing, damaged or has no house in the split.
std::vector<std::filesystem::path> ScenesOf(const TrainingScenes& scenes);

}  // namespace bulletnav::bench
