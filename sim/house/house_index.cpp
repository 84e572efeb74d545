// SPDX-License-Identifier: MIT
#include "sim/house/house_index.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/base/files.h"
#include "sim/house/json_node.h"

namespace bulletnav::sim {

nlohmann::ordered_json ToJson(const std::vector<HouseEntry>& houses) {
  auto list = nlohmann::ordered_json::array();
  for (const HouseEntry& house : houses) {
    list.push_back({{"file", house.file},
                    {"split", NameOf(house.split)},
                    {"seed", house.seed},
                    {"rooms", house.rooms},
                    {"area_m2", std::round(100.0 * house.area_m2) / 100.0}});
  }
  return list;
}

std::vector<HouseEntry> ReadHouseIndex(const std::filesystem::path& index) {
  const JsonNode root =
      JsonNode::Parse(ReadTextFile(index), index, "remove it and make the houses again");
  const JsonNode houses = root["houses"];
  std::vector<HouseEntry> entries;
  for (std::size_t i = 0; i < houses.size(1); ++i) {
    const JsonNode house = houses[i];
    entries.push_back({house["file"].ToString(), house["split"].ToEnum<Split>(),
                       house["seed"].ToUint(), static_cast<int>(house["rooms"].ToUint()),
                       static_cast<double>(house["area_m2"].ToPositive())});
  }
  return entries;
}

}  // namespace bulletnav::sim
