// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

enum class Split { kTrain, kVal, kTest };

template <>
struct EnumNames<Split> {
  static constexpr std::array kNames = {std::pair{"train", Split::kTrain},
                                        std::pair{"val", Split::kVal},
                                        std::pair{"test", Split::kTest}};
};

/// One line of a folder of houses.
struct HouseEntry {
  std::string file;  // "house_012.glb", in the folder of the index
  Split split = Split::kTrain;
  std::uint64_t seed = 0;
  int rooms = 0;
  double area_m2 = 0.0;
};

/// A house a seed from `first_seed` on, split 68 / 4 / 14 into train / val / test, as the 86 Gibson
/// scenes of NTS (section 5) are, or in proportion.
struct HouseSetSpec {
  int count = 86;
  std::uint64_t first_seed = 0;
  int workers = 0;  // 0: one a processor
};

/// Whether the folder holds an index of these houses. Throws FileError if it is one of others,
/// Error as WriteHouseSet.
bool HasHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec);

/// Writes house_NNN.glb, house_NNN.json (see house_json.h) and, last, index.json into `folder`.
/// `advance` is called after each house, from any thread. The files do not depend on the number of
/// workers.
/// Throws Error if count is not in 1..9999, FileError if the folder holds an index of other houses
/// or cannot be written; no house is begun after that.
std::vector<HouseEntry> WriteHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec,
                                      const std::function<void()>& advance);

/// Reads index.json: {"first_seed", "houses": [{"file", "split", "seed", "rooms", "area_m2"}]}.
/// Throws FileError naming the file and what is wrong in it.
std::vector<HouseEntry> ReadHouseIndex(const std::filesystem::path& index);

}  // namespace bulletnav::sim
