// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

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
  std::string kind = {};  // of a building; empty for the homes of sets that name no kinds
};

/// [{"file", "split", "seed", "rooms", "area_m2"}], as in index.json, and "kind" where there is
/// one; areas to two digits.
nlohmann::ordered_json ToJson(const std::vector<HouseEntry>& houses);

/// Reads index.json: {"first_seed", "houses": [{"file", "split", "seed", "rooms", "area_m2"}]}, and
/// "kind" of those that have one.
/// Throws FileError naming the file and what is wrong in it.
std::vector<HouseEntry> ReadHouseIndex(const std::filesystem::path& index);

}  // namespace bulletnav::sim
