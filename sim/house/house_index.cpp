// SPDX-License-Identifier: MIT
#include "sim/house/house_index.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/base/files.h"
#include "sim/config/json_node.h"

namespace bulletnav::sim {

nlohmann::ordered_json ToJson(const std::vector<HouseEntry>& houses) {
  auto list = nlohmann::ordered_json::array();
  for (const HouseEntry& house : houses) {
    nlohmann::ordered_json item = {{"file", house.file},
                                   {"split", NameOf(house.split)},
                                   {"seed", house.seed},
                                   {"rooms", house.rooms},
                                   {"area_m2", std::round(100.0 * house.area_m2) / 100.0}};
    if (!house.kind.empty()) item["kind"] = house.kind;
    list.push_back(std::move(item));
  }
  return list;
}

std::vector<HouseEntry> ReadHouseIndex(const std::filesystem::path& index) {
  const std::string remedy = "remove it and make the houses again";
  const auto document = ParseJson<FloatJson>(ReadTextFile(index), index, 1, remedy);
  const JsonNode<FloatJson> houses = JsonNode(document, index, "", remedy).At("houses");
  std::vector<HouseEntry> entries;
  for (std::size_t i = 0; i < houses.Size(1); ++i) {
    const JsonNode<FloatJson> house = houses.Item(i);
    entries.push_back({house.At("file").Text(), house.At("split").Enum<Split>(),
                       house.At("seed").Whole(), static_cast<int>(house.At("rooms").Whole()),
                       static_cast<double>(house.At("area_m2").Positive()),
                       house.Has("kind") ? house.At("kind").Text() : ""});
  }
  return entries;
}

}  // namespace bulletnav::sim
