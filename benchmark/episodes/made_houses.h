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

/// A file that says of which buildings a set is; see sim::HouseSetSpec.
struct HouseSetFile {
  std::uint64_t first_seed = 0;
  std::vector<sim::SetPart> parts;

  template <class V>
  void Visit(V& v) {
    v("first_seed", first_seed);
    v.Required("parts", parts);
  }
  void Validate() const;
};

/// Houses, or buildings of several kinds, that are generated if the folder has none yet; see
/// sim::HouseSetSpec.
struct HousesSpec {
  std::string folder;
  int count = 86;
  std::uint64_t first_seed = 0;
  std::optional<std::vector<sim::SetPart>> parts = {};  // instead of `count` homes
  std::optional<sim::Refurnish> refurnished = {};  // the same houses, some rooms furnished anew
  std::optional<std::string> set = {};  // a HouseSetFile, in place of first seed, count and parts

  template <class V>
  void Visit(V& v) {
    v.Required("folder", folder);
    v("count", count);
    v("first_seed", first_seed);
    v("parts", parts);
    v("refurnished", refurnished);
    v("set", set);
  }
  void Validate() const;
};

/// Generates them unless the folder's index says that they are there; goes on with what a stopped
/// call of the same version `made_by` left. Waits while another process generates them.
/// Throws sim::FileError if the folder holds other houses, or the file of the set is no such file.
void MakeHouses(const HousesSpec& houses, const std::string& made_by, int workers,
                const StartProgress& start);

/// Their files in order, of all splits. Throws sim::FileError if they are not there, and as
/// MakeHouses.
std::vector<std::filesystem::path> FilesOf(const HousesSpec& houses);

}  // namespace bulletnav::bench
