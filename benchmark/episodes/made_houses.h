// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/config/yaml_reader.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {

/// Begins to tell about `total` pieces of work; what it returns is called after each, from any
/// thread.
using StartProgress = std::function<std::function<void()>(const std::string& what, int total)>;

/// Houses, or buildings of several kinds, that are generated if the folder has none yet; see
/// sim::HouseSetSpec.
struct HousesSpec {
  std::string folder;
  int count = 86;
  std::uint64_t first_seed = 0;
  std::optional<std::vector<sim::SetPart>> parts = {};  // instead of `count` homes
  std::optional<sim::Refurnish> refurnished = {};  // the same houses, some rooms furnished anew

  template <class V>
  void Visit(V& v) {
    v.Required("folder", folder);
    v("count", count);
    v("first_seed", first_seed);
    v("parts", parts);
    v("refurnished", refurnished);
  }
  void Validate() const;
};

/// Generates them unless the folder's index says that they are there; goes on with what a stopped
/// call of the same version `made_by` left. Waits while another process generates them.
/// Throws sim::FileError if the folder holds other houses.
void MakeHouses(const HousesSpec& houses, const std::string& made_by, int workers,
                const StartProgress& start);

/// Their files in order, of all splits. Throws sim::FileError if they are not there.
std::vector<std::filesystem::path> FilesOf(const HousesSpec& houses);

}  // namespace bulletnav::bench
